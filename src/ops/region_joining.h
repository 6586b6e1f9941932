// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ops/regions.h"
#include <pcl_ops/plane_merging.h>

namespace pcl_ops::internal {

/** \brief Makes one of regions that touch and are pieces of one plane.
 *
 * Each region picks the larger neighbor with which it shares most border that fits
 * both; regions that pick nobody take all that picked them; and again, some rounds. No
 * order decides, as it does where the best pair is joined first: one point less would
 * change the first pair, and with it all that follow. */
void
joinTouching (const Places& places, unsigned threads, Regions& regions);

/** \brief Makes one of regions that are one plane without touching, such as a wall
 * behind a cupboard, in the same way.
 * \param[in] merging its angle, and how many noises they may be apart */
void
joinOverGaps (const MergingParameters& merging, Regions& regions);

} // namespace pcl_ops::internal
