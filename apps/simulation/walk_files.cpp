// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "walk_files.h"

#include "packed_cloud.h"
#include <cli/interruption.h>
#include <cli/memory.h>
#include <io/output_file.h>

#include <array>
#include <cstdio>
#include <filesystem>

namespace pcl_ops::simulation {

namespace {

std::string
nameOf (std::size_t frame)
{
  std::array<char, 32> name{};
  std::snprintf (name.data(), name.size(), "frame_%03zu.pcd", frame);
  return name.data();
}

} // namespace

WalkRecording
recorded (const Scene& scene,
          const DepthCamera& camera,
          const Poses& poses,
          const NoiseParameters& noise,
          CloudLayout layout,
          std::uint32_t seed)
{
  const auto look = [=] (std::size_t frame) {
    DepthCamera placed = camera;
    placed.pose = poses[frame];
    const DepthImage image =
        measureDepth (scene, placed, noise, seed + std::uint32_t (frame));
    placed.pose = Eigen::Isometry3d::Identity();
    return toSurfaceCloud (image, placed, layout);
  };
  return {poses.size(), look, "give a smaller --width and --height"};
}

WalkRecording
recorded (const Scene& scene,
          const Lidar& lidar,
          const Poses& poses,
          double noise_scale,
          CloudLayout layout,
          std::uint32_t seed)
{
  const auto look = [=] (std::size_t frame) {
    Lidar placed = lidar;
    placed.pose = poses[frame];
    const LidarScan scan =
        scanAround (scene, placed, noise_scale, seed + std::uint32_t (frame), frame);
    return toSurfaceCloud (scan, Eigen::Isometry3d::Identity(), layout);
  };
  return {poses.size(), look, "give another --sensor"};
}

std::uint64_t
saveWalk (const std::string& folder,
          const WalkRecording& walk,
          apps::Progress& progress)
{
  apps::makeFolder (folder);
  std::uint64_t points = 0;
  for (std::size_t i = 0; i < walk.frames; ++i) {
    apps::stopIfInterrupted();
    const std::string file = (std::filesystem::path (folder) / nameOf (i)).string();
    apps::inMemory (file, walk.advice, [&] {
      const auto cloud = walk.look (i);
      apps::savePcd (file, packedCloud (cloud));
      points += cloud.size();
    });
    progress.step();
  }
  // Those of a longer walk before it would be taken for frames of this one.
  const std::filesystem::path path = folder;
  for (std::size_t i = walk.frames; std::filesystem::remove (path / nameOf (i));)
    ++i;
  return points;
}

} // namespace pcl_ops::simulation
