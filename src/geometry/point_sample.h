// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "geometry/points.h"

#include <cstddef>

namespace pcl_ops::internal {

/** \brief Some of the points, the same ones whatever their order.
 * \param[in] positions all
 * \param[in] wanted about so many, or all where there are fewer */
Coordinates
samplePoints (const Coordinates& positions, std::size_t wanted);

} // namespace pcl_ops::internal
