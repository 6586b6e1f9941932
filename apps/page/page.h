// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "point_sample.h"
#include <io/shifted_cloud.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief With this number of points a page has 16 MB: 8 letters for each point. */
inline constexpr std::size_t max_points_on_page = 2'000'000;

/** \brief The points of a plane, or those on no plane, rounded to a lattice. The
 * lattice divides the bounding box of the points along each axis into 65535 equal
 * steps, so that a coordinate takes 16 bits. */
struct PointGroup {
  /** \brief The corner of the box with the smallest coordinates. A point is at origin +
   * step * the numbers in \ref steps. */
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  /** \brief Length of a step along each axis; 0 if the box is flat along the axis. */
  Eigen::Vector3d step = Eigen::Vector3d::Zero();
  /** \brief Number of finite points of the plane, or on no plane; \ref steps has all or
   * some of them. */
  std::size_t all_points = 0;
  /** \brief For each point its numbers of steps along x, y and z. The order is
   * pseudo-random, so that the first points are an even sample. */
  std::vector<std::array<std::uint16_t, 3>> steps;
};

/** \brief Returns each sample as a group, rounded to the lattice of the group. */
std::vector<PointGroup>
toGroups (const std::vector<SampledPoints>& samples);

/** \brief Returns the points of a cloud in groups: one for each plane, then one for no
 * plane. If the cloud has more points than \p max_points, it is sampled (\ref
 * PointSample), so that all groups together have no more.
 * \param[in] labels for each point: 0 for no plane, else the index of its plane plus 1
 * \param[in] planes number of planes
 * \param[in] position_of returns the coordinates of a point by its index */
std::vector<PointGroup>
groupPoints (const std::vector<std::uint32_t>& labels,
             std::size_t planes,
             const PositionOf& position_of,
             std::size_t max_points = max_points_on_page);

/** \brief Writes a page that shows a cloud in a browser, all in one file (\ref
 * writeFile).
 * \param[in] description the text of a JSON object for viewer.js. Its keys are "title",
 * "up" (unit vector), "view" (unit vector from the cloud to the eye), "backs" (whether
 * planes are shown from behind, too), "planes" (objects of \ref planeObject, each with
 * a "color" #rrggbb), and "edges" (each with its ends "from" and "to").
 * \param[in] groups one for each plane, then one for no plane
 * \param[in] shift is added to the positions in \p groups */
void
savePage (const std::string& file,
          const std::string& description,
          const std::vector<PointGroup>& groups,
          const Eigen::Vector3d& shift);

} // namespace pcl_ops::apps
