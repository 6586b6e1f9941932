// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/oriented_point_sampling.h>

#include <cstddef>

// The meaning of the paper's parameters for detection on neighborhoods.

namespace pcl_ops::internal {

/** \brief Least number of places of a cloud with planes. The check of thickness skips
 * planes with fewer places. */
inline constexpr std::size_t least_places = 6;

/** \brief Whether the sampling rate alpha_s would draw no point of a cloud with this
 * number of points: then no planes are detected. */
bool
drawsNothing (const OrientedPointSamplingParameters& parameters, std::size_t points);

/** \brief Returns the number of points of a neighborhood, its place included, from
 * alpha_s, k and the size of the cloud.
 * \param[in] places number of places; also the size of the cloud, unless
 * \p parameters.noise_of_whole has that of the whole */
std::size_t
neighborsOf (const OrientedPointSamplingParameters& parameters, std::size_t places);

/** \brief Returns the factor of the least number of points of a plane, by theta_N; 1
 * for the default. */
double
minPointsFactor (const OrientedPointSamplingParameters& parameters);

} // namespace pcl_ops::internal
