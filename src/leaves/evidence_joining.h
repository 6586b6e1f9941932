// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "leaves/leaf_surfels.h"

#include <vector>

namespace pcl_ops::internal {

/** \brief Joins planes for which too little speaks with one beside them where more
 * speaks for both together than for either (\ref evidenceOf). What noise or a slight
 * bend divided looks like facets, of which each is where the other one goes on; and
 * what is small in two pieces need not be so in one. Those that gain most come first;
 * the sum is at most 1.5 times as noisy as the noisier part.
 * \param[in] surfels of leaves without a plane
 * \return the planes that changed; those that went into others have no leaves */
std::vector<char>
joinByEvidence (const LeafCloud& cloud,
                const std::vector<LeafSurfel>& surfels,
                unsigned threads,
                LeafPlanes& planes);

} // namespace pcl_ops::internal
