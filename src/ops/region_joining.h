// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ops/regions.h"
#include <pcl_ops/plane_merging.h>

namespace pcl_ops::internal {

/** \brief Makes one of regions that touch and are pieces of one plane.
 *
 * In each of some rounds each region picks the larger neighbor with which it shares
 * most border that lies on the planes of both; then regions that picked none take all
 * that picked them. So no order decides. If the best pair were joined first, one point
 * less could change that pair, and with it all that follow. */
void
joinTouching (const Places& places, unsigned threads, Regions& regions);

/** \brief Makes one of regions that are one plane without touching, such as a wall
 * behind a cupboard, in the same way.
 * \param[in] merging has the largest angle between their normals, and how many noises
 * they may be apart */
void
joinOverGaps (const MergingParameters& merging, Regions& regions);

} // namespace pcl_ops::internal
