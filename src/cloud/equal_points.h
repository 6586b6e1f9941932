// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud/points.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace pcl_ops::internal {

/** \brief For each point the number of the first one at its place, itself or not. */
using FirstAtPlace = std::vector<std::uint32_t>;

/** \brief Of a point that is no reading: so many are at its place that it must be what
 * a sensor writes where it has none, mostly (0, 0, 0). Of one that is not finite, too.
 */
constexpr std::uint32_t no_reading = std::numeric_limits<std::uint32_t>::max();

/** \brief Finds points of equal coordinates where they would decide over others: where
 * many are at one place, or where a good share of all is not alone at its own.
 *
 * The same points, whatever their order, give the same places. Of points that are
 * nearly all alone it reads each one once.
 * \return empty where equal points are too few to decide anything */
FirstAtPlace
firstAtPlace (const Coordinates& points, unsigned threads);

} // namespace pcl_ops::internal
