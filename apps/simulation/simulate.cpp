// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "simulate.h"

#include "lidar.h"
#include "poses.h"
#include "shapes.h"
#include "street.h"
#include "survey.h"

namespace pcl_ops::simulation {

SimulatedCloud
simulate (const Simulation& simulation)
{
  const std::uint32_t seed = simulation.seed;
  const double noise = simulation.noise;
  const auto pointsOr = [&simulation] (std::size_t usual) {
    return simulation.points ? std::size_t (*simulation.points) : usual;
  };
  const auto seen =
      [&] (const Scene& scene, const Scan& scan, const Eigen::Isometry3d& pose) {
        return labeledBySize (toSurfaceCloud (scan, pose, simulation.organized),
                              surfacePlanes (scene));
      };
  if (simulation.scene == "survey")
    return scanSurvey (makeSurvey (seed), pointsOr (points_of_survey), noise, seed);
  if (simulation.scene == "shapes")
    return scanShapes (makeShapes (seed), pointsOr (points_of_shapes), noise, seed);
  if (simulation.scene == "street") {
    const Street street = makeStreet (seed);
    const Eigen::Isometry3d pose = drawSensorPose (street, seed);
    const Lidar lidar = lidarOf (simulation.sensor);
    return seen (
        street.scene, scanAround (street.scene, lidar, pose, noise, seed), pose);
  }
  const Room room =
      simulation.scene == "furniture" ? makeFurnishedCorner (seed) : makeRoom (seed);
  if (simulation.points)
    return scanDensely (room.scene, pointsOr (0), noise, seed);
  const Eigen::Isometry3d pose = drawCameraPose (room, seed);
  return seen (
      room.scene,
      scanByCamera (
          room.scene, simulation.camera, pose, {noise, simulation.has_raw_depth}, seed),
      pose);
}

WalkView
simulateWalk (const Simulation& simulation, std::size_t frames)
{
  const Room room = makeRoom (simulation.seed);
  const Poses poses = drawWalk (room, frames, simulation.seed);
  return {poses, [=] (std::size_t frame) {
            const Scan scan =
                scanByCamera (room.scene,
                              simulation.camera,
                              poses[frame],
                              {simulation.noise, simulation.has_raw_depth},
                              simulation.seed + std::uint32_t (frame));
            return toSurfaceCloud (
                scan, Eigen::Isometry3d::Identity(), simulation.organized);
          }};
}

} // namespace pcl_ops::simulation
