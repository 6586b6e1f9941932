// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fspf/local_plane_sampling.h"
#include "geometry/points.h"
#include <pcl_ops/plane_detector.h>

namespace pcl_ops::internal {

/** \brief Points in the order a search has them, and the spheres around each. */
struct Spheres {
  Coordinates points;
  SphereFinder find;
};

/** \brief Spheres by the user's search, or, several times faster, in a grid of voxels.
 * \param[in] input, points used as long as the spheres are
 * \param[in] radius r2 [m]
 * \param[in] threads that build the search; 0: all */
Spheres
spheresAround (const DetectorInput& input,
               const Points& points,
               double radius,
               unsigned threads);

} // namespace pcl_ops::internal
