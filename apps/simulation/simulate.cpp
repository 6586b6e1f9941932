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

WayView
simulateWay (const Simulation& simulation, std::size_t frames)
{
  const std::uint32_t seed = simulation.seed;
  const auto viewOf = [&] (const Poses& poses, const auto& scanOf) {
    return WayView{poses, [=, organized = simulation.organized] (std::size_t frame) {
                     const auto of_frame = seed + std::uint32_t (frame);
                     return toSurfaceCloud (scanOf (frame, poses[frame], of_frame),
                                            Eigen::Isometry3d::Identity(),
                                            organized);
                   }};
  };
  if (simulation.scene == "drive") {
    const Street street = makeStreet (seed);
    return viewOf (drawDrive (street, frames, seed),
                   [scene = street.scene,
                    lidar = lidarOf (simulation.sensor),
                    noise = simulation.noise] (auto frame, auto pose, auto of_frame) {
                     return scanAround (scene, lidar, pose, noise, of_frame, frame);
                   });
  }
  const Room room = makeRoom (seed);
  const CameraNoise noise{simulation.noise, simulation.has_raw_depth};
  return viewOf (drawWalk (room, frames, seed),
                 [scene = room.scene, camera = simulation.camera, noise] (
                     auto, auto pose, auto of_frame) {
                   return scanByCamera (scene, camera, pose, noise, of_frame);
                 });
}

} // namespace pcl_ops::simulation
