// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/oriented_point_sampling.h>

#include <cstddef>

// What the paper's parameters mean for detection on neighborhoods: alpha_s
// (sampling_rate), k (number of neighbors) and theta_N (min_samples).

namespace pcl_ops::internal {

/** \brief In clouds with fewer places no planes are detected. Planes with fewer places
 * are not checked for their thickness. Any three points lie on a plane, so the scatter
 * of a few more says little about noise. */
inline constexpr std::size_t min_places = 6;

/** \brief Whether the sampling rate alpha_s would draw hardly any of \p points points:
 * then no planes are detected. */
bool
drawsNothing (const OrientedPointSamplingParameters& parameters, std::size_t points);

/** \brief Returns the number of points of a neighborhood, its place included, from
 * alpha_s, k and the size of the cloud.
 * \param[in] places number of places, the size of the cloud. But if these places are a
 * part of a larger cloud, \p parameters.noise_of_whole has the size of that cloud
 * \return at most \p places */
std::size_t
neighborhoodSizeFor (const OrientedPointSamplingParameters& parameters,
                     std::size_t places);

/** \brief Returns the factor by which theta_N multiplies the least number of points of
 * a plane; 1 for the default theta_N. */
double
minPointsFactor (const OrientedPointSamplingParameters& parameters);

} // namespace pcl_ops::internal
