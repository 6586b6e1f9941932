// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pcl_ops::internal {

/** \brief Squared width of a uniform distribution over its variance: evenly spread
 * points with the variance v along an axis extend sqrt (12 v) along it. */
inline constexpr double squared_width_of_variance = 12.0;

/** \brief Number of coefficients that the fit of a plane estimates: the distances of n
 * points to their fitted plane have only n - 3 degrees of freedom. */
inline constexpr double parameters_of_plane = 3.0;

} // namespace pcl_ops::internal
