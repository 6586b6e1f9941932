// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scenes.h"

namespace pcl_ops::simulation {

namespace {

Site
siteOf (const Simulation& simulation)
{
  return simulation.scene == "furniture" ? makeFurnishedCorner (simulation.seed)
         : simulation.hasLidar()         ? makeStreet (simulation.seed)
                                         : makeRoom (simulation.seed);
}

Isometry3d
drawError (Random& random, double size)
{
  const double of_each_axis = size / std::sqrt (3.0);
  const auto draw = [&] (double unit) {
    Vector3d drawn;
    for (double& number : drawn)
      number = unit * of_each_axis * random.gaussian();
    return drawn;
  };
  const Vector3d rotation = draw (pi / 180.0);
  Isometry3d error = at (draw (0.01));
  if (rotation.norm() > 0.0)
    error.rotate (Eigen::AngleAxisd (rotation.norm(), rotation.normalized()));
  return error;
}

} // namespace

SensorView
viewOf (const Simulation& simulation, std::size_t frames)
{
  const std::string& name = simulation.scene;
  const Seed seed = simulation.seed;
  const Site site = siteOf (simulation);
  const Poses poses = name == "walk"          ? drawWalk (site, frames, seed)
                      : name == "drive"       ? drawDrive (site, frames, seed)
                      : simulation.hasLidar() ? Poses{drawSensorPose (site, seed)}
                                              : Poses{drawCameraPose (site, seed)};
  const auto scan = [=] (std::size_t frame) {
    const View view{site.scene, poses[frame], seed + std::uint32_t (frame)};
    const double noise = simulation.noise;
    return simulation.hasLidar()
               ? scanAround (view, lidarOf (simulation.sensor), noise, frame)
               : scanByCamera (
                     view, simulation.camera, {noise, simulation.has_raw_depth});
  };
  return {site.scene, poses, scan};
}

SimulatedCloud
simulate (const Simulation& simulation)
{
  const Seed seed = simulation.seed;
  const double noise = simulation.noise;
  constexpr std::size_t points_of_survey = 600'000;
  constexpr std::size_t points_of_shapes = 250'000; // about 5000 on a square meter
  const auto pointsOr = [&simulation] (std::size_t usual) {
    return simulation.points ? std::size_t (*simulation.points) : usual;
  };
  if (simulation.scene == "survey")
    return scanSurvey (makeSurvey (seed), pointsOr (points_of_survey), noise, seed);
  if (simulation.scene == "shapes")
    return simulateShapes (pointsOr (points_of_shapes), noise, seed);
  if (simulation.points)
    return scanDensely (siteOf (simulation).scene, pointsOr (0), noise, seed);
  const SensorView view = viewOf (simulation);
  return labeledBySize (
      toSurfaceCloud (view.scan (0), view.poses[0], simulation.organized),
      surfacePlanes (view.scene));
}

Poses
measured (const Poses& poses, const PoseErrors& errors, Seed seed)
{
  Random random = randomFor (Purpose::PoseError, seed);
  Poses result;
  Isometry3d drifting = Isometry3d::Identity();
  for (std::size_t i = 0; i < poses.size(); ++i) {
    drifting = i == 0 ? poses[0]
                      : drifting * poses[i - 1].inverse() * poses[i] *
                            drawError (random, errors.drift);
    result.push_back (drifting * drawError (random, errors.each));
  }
  return result;
}

} // namespace pcl_ops::simulation
