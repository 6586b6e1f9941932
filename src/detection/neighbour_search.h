// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "geometry/points.h"
#include <pcl_ops/plane_detector.h>

namespace pcl_ops::internal {

/** \brief The user's search over the finite points, or, where there is none, the
 * library's own.
 * \param[in] input used as long as the search is
 * \param[in] points the finite points of it
 * \param[in] threads that may ask the library's own; 0: all */
NeighborSearch
searchOver (const DetectorInput& input, const Points& points, unsigned threads);

} // namespace pcl_ops::internal
