// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "depth_noise.h"
#include "simulated_cloud.h"
#include "walk.h"
#include <cli/progress.h>

#include <cstdint>
#include <functional>
#include <string>

namespace pcl_ops::simulation {

/** \brief What is seen on a walk or a drive. */
struct WalkRecording {
  std::size_t frames = 0;
  /** \brief The points of a frame in the sensor's frame, labels as in all others. */
  std::function<pcl::PointCloud<pcl::PointXYZL> (std::size_t)> look;
  /** \brief What to do if a frame does not fit into the memory. */
  const char* advice = "";
};

/** \brief What a depth camera sees: x right, y down, z forward.
 * \param[in] camera its pose does not count
 * \param[in] seed each frame has noise of its own, by this and its number */
WalkRecording
recorded (const Scene& scene,
          const DepthCamera& camera,
          const Poses& poses,
          const NoiseParameters& noise,
          CloudLayout layout,
          std::uint32_t seed);

/** \brief The same of a lidar: x forward, y left, z up. */
WalkRecording
recorded (const Scene& scene,
          const Lidar& lidar,
          const Poses& poses,
          double noise_scale,
          CloudLayout layout,
          std::uint32_t seed);

/** \brief Writes what is seen as FOLDER/frame_000.pcd and so on.
 * \param[in,out] progress of all frames
 * \return points in all of them
 * \throw WorkError if one cannot be written */
std::uint64_t
saveWalk (const std::string& folder,
          const WalkRecording& walk,
          apps::Progress& progress);

} // namespace pcl_ops::simulation
