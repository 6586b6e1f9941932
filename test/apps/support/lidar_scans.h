// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

/** \brief Paths of all lidar scans in a data folder, in no order: the clouds in its
 * folder lidar, and those in real and wild whose names begin with "lidar". Each scan is
 * in the frame of its sensor. */
inline std::vector<std::filesystem::path>
lidarScansIn (const std::filesystem::path& data)
{
  std::vector<std::filesystem::path> scans;
  for (const std::string folder : {"lidar", "real", "wild"})
    if (std::filesystem::exists (data / folder))
      for (const auto& entry : std::filesystem::directory_iterator (data / folder)) {
        const std::filesystem::path& file = entry.path();
        const bool is_cloud = file.extension() == ".pcd" || file.extension() == ".xyz";
        const bool is_by_lidar =
            folder == "lidar" || file.filename().string().rfind ("lidar", 0) == 0;
        if (is_cloud && is_by_lidar)
          scans.push_back (file);
      }
  return scans;
}
