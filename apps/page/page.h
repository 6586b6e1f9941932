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

/** \brief A page with this number of points has 16 MB: 8 letters for each point. */
inline constexpr std::size_t max_points_on_page = 2'000'000;

/** \brief The points of a plane, or of no plane, rounded to a lattice of their own: it
 * divides each axis of their bounding box into 65535 equal steps, so that a coordinate
 * takes 16 bits. */
struct PointGroup {
  /** \brief A position is origin + step * \ref steps, for each axis. A step is 0 if the
   * box is flat along the axis. */
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Vector3d step = Eigen::Vector3d::Zero();
  /** \brief Number of finite points of the group; \ref steps has all or some of them.
   */
  std::size_t all_points = 0;
  /** \brief The steps of each point along the axes, in pseudo-random order: the first
   * ones are an even sample. */
  std::vector<std::array<std::uint16_t, 3>> steps;
};

/** \brief Rounds each sample to the lattice of a \ref PointGroup. */
std::vector<PointGroup>
toGroups (const std::vector<SampledPoints>& samples);

/** \brief Groups the points of a cloud by planes, points on no plane last, with at most
 * \p max_points in all groups together (\ref PointSample).
 * \param[in] labels per point: 0 for no plane, else the index of the plane plus 1
 * \param[in] planes number of planes */
std::vector<PointGroup>
groupPoints (const std::vector<std::uint32_t>& labels,
             std::size_t planes,
             const PositionOf& position_of,
             std::size_t max_points = max_points_on_page);

/** \brief Writes a page that shows a cloud in a browser, all in one file (\ref
 * writeFile).
 * \param[in] description a JSON object for viewer.js: "title", "up", "view" (direction
 * from the cloud to the eye), "backs" (whether planes are shown from behind, too),
 * "planes" as lists of planes have them, each with its "color" (#rrggbb), and "edges",
 * each with its ends "from" and "to"
 * \param[in] groups one for each plane, then one for no plane
 * \param[in] shift is added to the positions in \p groups */
void
savePage (const std::string& file,
          const std::string& description,
          const std::vector<PointGroup>& groups,
          const Eigen::Vector3d& shift);

} // namespace pcl_ops::apps
