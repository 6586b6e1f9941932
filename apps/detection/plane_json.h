// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <pcl_ops/plane.h>
#include <pcl_ops/plane_extent.h>

#include <cstddef>

namespace pcl_ops::apps {

nlohmann::ordered_json
toArray (const Eigen::Vector3d& vector);

/** \brief A plane as the lists of planes have it; its points are those of its moments.
 */
nlohmann::ordered_json
planeObject (std::size_t id, const PlaneSegment& segment, const PlaneExtent& extent);

} // namespace pcl_ops::apps
