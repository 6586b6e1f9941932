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

/** \brief A page with this number of points has 16 MB. */
inline constexpr std::size_t max_points_on_page = 2'000'000;

/** \brief The points of a plane, or of no plane, on a lattice of their own: 16 bits
 * along each axis of their bounding box. */
struct PointGroup {
  /** \brief A position is origin + step * steps, for each axis. */
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Vector3d step = Eigen::Vector3d::Zero();
  /** \brief Number of points in the cloud; \ref steps has all or some of them. */
  std::size_t all_points = 0;
  /** \brief The steps of each point along the axes, in pseudo-random order: the first
   * ones are an even sample. */
  std::vector<std::array<std::uint16_t, 3>> steps;
};

/** \brief Rounds each sample to a lattice. */
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
 * \param[in] description a JSON object for viewer.js: "title", "up", "planes" as lists
 * of planes have them, each with its "color", and "edges"
 * \param[in] groups one for each plane, then one for no plane
 * \param[in] shift is added to all positions */
void
savePage (const std::string& file,
          const std::string& description,
          const std::vector<PointGroup>& groups,
          const Eigen::Vector3d& shift);

} // namespace pcl_ops::apps
