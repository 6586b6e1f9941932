// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/oriented_point_sampling.h>

#include <cstddef>

// What the parameters of the paper mean on neighborhoods.

namespace pcl_ops::internal {

/** \brief Fewer places are no plane. */
inline constexpr std::size_t least_places = 6;

/** \brief alpha_s: whether a share of the points is too small to draw one of them. */
bool
drawsNothing (const OrientedPointSamplingParameters& parameters, std::size_t points);

/** \brief alpha_s, k: how many nearest points each of so many places has, itself
 * included. */
std::size_t
neighborsOf (const OrientedPointSamplingParameters& parameters, std::size_t places);

/** \brief theta_N: over the usual one. */
double
minPointsFactor (const OrientedPointSamplingParameters& parameters);

} // namespace pcl_ops::internal
