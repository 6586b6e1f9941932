// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <pcl_ops/plane.h>
#include <pcl_ops/plane_extent.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl_ops::apps {

nlohmann::ordered_json
toArray (const Eigen::Vector3d& vector);

/** \brief A plane as the lists of planes have it; its points are those of its moments.
 */
nlohmann::ordered_json
planeObject (std::size_t id, const PlaneSegment& segment, const PlaneExtent& extent);

/** \brief The planes of a file, as far as it tells of them. */
struct PlaneList {
  std::vector<std::uint64_t> ids;
  /** \brief Without inliers, and with the moments of points spread evenly inside the
   * hull, about whose middle they are; of a plane without a hull its moments reach
   * without an end. */
  std::vector<PlaneSegment> planes;
};

/** \brief Reads the planes of pcl_ops_segment --planes FILE.json or of planes.json of
 * pcl_ops_tiles: of each id, orientation, points, coefficients, centroid and rms, and
 * the hull where it has one.
 * \throws WorkError that names the file and the key at fault */
PlaneList
loadPlaneList (const std::string& file);

} // namespace pcl_ops::apps
