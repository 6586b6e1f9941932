// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ops/regions.h"
#include <pcl_ops/plane_merging.h>

namespace pcl_ops::internal {

/** \brief Joins regions that touch each other and are pieces of one plane.
 *
 * In each round each region picks one of the larger regions that it touches and whose
 * plane it is a piece of: the one with which it shares most border places that lie on
 * the plane of the other region. Then each region that picked none takes all regions
 * that picked it. So the result hardly depends on the order of the regions: ties do,
 * and Region::has_parts of a region that takes several in one round. If only the best
 * pair were joined at a time, one point less could change which pair is best, and so
 * all later pairs. Rounds end when no region picks another one. */
void
joinTouching (const Places& places, unsigned threads, Regions& regions);

/** \brief Joins regions that are pieces of one plane but do not touch each other, such
 * as the pieces of a wall on both sides of a cupboard. Works in rounds as \ref
 * joinTouching, but each region picks the larger region with most points per squared
 * distance of the centroids, over a limited gap. Only the 5000 largest regions are
 * compared.
 * \param[in] merging its angle_threshold is the largest angle between normals [rad].
 * Its noise_factor limits the distance of a region from the plane it joins, in units of
 * the noise; by default PlaceConstants::noises_of_join. Other members are not used */
void
joinOverGaps (const MergingParameters& merging, Regions& regions);

} // namespace pcl_ops::internal
