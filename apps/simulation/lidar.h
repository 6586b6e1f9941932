// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulated_cloud.h"

#include <string>
#include <vector>

namespace pcl_ops::simulation {

/** \brief Standard deviation of a lidar's distances [m]. */
constexpr double lidar_sigma = 0.02;

/** \brief A lidar in its axes: x forward, y left, z up. It sends some beams at once,
 * one above the other, highest first, and so around clockwise; or with \ref beams 1 a
 * single one along a rosette whose gaps the next scans fill. */
struct Lidar {
  std::string name = "lidar-64";
  int beams = 64;
  /** \brief How often they are sent in a scan. */
  int steps = 1900;
  /** \brief Elevations of the outer beams; of a rosette those of its edge [degree]. */
  double highest = 2.0, lowest = -24.8;
  /** \brief Readings beyond are lost [m]. */
  double farthest = 120.0;

  bool
  isRosette () const
  {
    return beams == 1;
  }
};

/** \brief The names that \ref lidarOf knows. */
std::vector<std::string>
lidarNames ();

/** \brief A lidar like a Velodyne HDL-64E, HDL-32E or VLP-16 ("lidar-64", "lidar-32",
 * "lidar-16") or a Livox Avia ("livox").
 * \param[in] name one of \ref lidarNames */
Lidar
lidarOf (const std::string& name);

/** \brief Casts all rays of a scan from where the lidar is; distances are noisy.
 * \param[in] scene best \ref divided
 * \param[in] pose from the lidar's frame to that of the scene
 * \param[in] number of the scan in a row of them: a rosette goes on where the last
 * scan ended */
Scan
scanAround (const Scene& scene,
            const Lidar& lidar,
            const Eigen::Isometry3d& pose,
            double noise_scale,
            std::uint32_t seed,
            std::size_t number = 0);

} // namespace pcl_ops::simulation
