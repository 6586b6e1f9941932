// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud/points.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace pcl_ops::internal {

/** \brief For each point the lowest index of all points with its coordinates, which may
 * be its own index; or \ref no_reading. Empty: all points may be used as they are. */
using FirstAtPlace = std::vector<std::uint32_t>;

/** \brief Marks a point that is no reading: so many points have its coordinates that
 * they must be a sensor's code for a missing reading, mostly (0, 0, 0). Also marks
 * non-finite points. */
constexpr std::uint32_t no_reading = std::numeric_limits<std::uint32_t>::max();

/** \brief Finds points with equal coordinates if there are so many that they would
 * distort the spacing of the points: if very many points are at one place, or if a
 * large share of all points has duplicates.
 *
 * The places found do not depend on the order of the points. If nearly all points are
 * distinct, the function reads each only once.
 * \param[in] threads largest number of threads; 0: one for each processor
 * \return empty if there are too few equal points to matter. If there are missing
 * readings, but too few other equal points, each reading has its own index */
FirstAtPlace
firstAtPlace (const Coordinates& points, unsigned threads);

} // namespace pcl_ops::internal
