// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/oriented_point_sampling.h>

#include <cstddef>

// What the paper's parameters mean for detection on neighborhoods: the sampling rate
// alpha_s, the number of neighbors k, and theta_N, min_samples.

namespace pcl_ops::internal {

/** \brief Least number of places of a cloud with planes. The check of thickness skips
 * planes with fewer places. */
inline constexpr std::size_t least_places = 6;

/** \brief Whether the sampling rate alpha_s would draw no point of a cloud with this
 * number of points, or hardly any: then no planes are detected. */
bool
drawsNothing (const OrientedPointSamplingParameters& parameters, std::size_t points);

/** \brief Returns the number of points of a neighborhood, its place included, from
 * alpha_s, k and the size of the cloud.
 * \param[in] places number of places. It is the size of the cloud, too, unless these
 * places are a part of a cloud: then \p parameters.noise_of_whole has its size */
std::size_t
neighborhoodSizeFor (const OrientedPointSamplingParameters& parameters,
                     std::size_t places);

/** \brief Returns the factor by which theta_N multiplies the least number of points of
 * a plane; 1 for the default theta_N. */
double
minPointsFactor (const OrientedPointSamplingParameters& parameters);

} // namespace pcl_ops::internal
