// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "walk_files.h"

#include "packed_cloud.h"
#include "simulated_cloud.h"
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

std::uint64_t
saveWalk (const std::string& folder,
          const WalkRecording& walk,
          std::uint32_t seed,
          apps::Progress& progress)
{
  apps::makeFolder (folder);
  std::uint64_t points = 0;
  for (std::size_t i = 0; i < walk.poses.size(); ++i) {
    apps::stopIfInterrupted();
    const std::string file = (std::filesystem::path (folder) / nameOf (i)).string();
    apps::inMemory (file, "give a smaller --width and --height", [&] {
      DepthCamera camera = walk.camera;
      camera.pose = walk.poses[i];
      // Each frame has noise of its own.
      const DepthImage image =
          measureDepth (walk.room.scene, camera, walk.noise, seed + std::uint32_t (i));
      camera.pose = Eigen::Isometry3d::Identity();
      const auto cloud = toSurfaceCloud (image,
                                         camera,
                                         walk.organized ? CloudLayout::Organized
                                                        : CloudLayout::Readings);
      apps::savePcd (file, packedCloud (cloud));
      points += cloud.size();
    });
    progress.step();
  }
  // Those of a longer walk before it would be taken for frames of this one.
  const std::filesystem::path path = folder;
  for (std::size_t i = walk.poses.size(); std::filesystem::remove (path / nameOf (i));)
    ++i;
  return points;
}

} // namespace pcl_ops::simulation
