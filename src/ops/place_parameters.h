// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/oriented_point_sampling.h>

#include <cstddef>

// What the parameters of the paper mean on neighborhoods.

namespace pcl_ops::internal {

/** \brief Fewer places are no plane. */
inline constexpr std::size_t least_places = 6;

/** \brief Whether the sampling rate alpha_s is so small that of so many points none
 * would be drawn: then there are no planes. */
bool
drawsNothing (const OrientedPointSamplingParameters& parameters, std::size_t points);

/** \brief How many points neighborhoods have, their places included, by alpha_s and k.
 * \param[in] places so many has the cloud, unless the parameters have its noise */
std::size_t
neighborsOf (const OrientedPointSamplingParameters& parameters, std::size_t places);

/** \brief How many times the usual number of points a plane needs, by theta_N. */
double
minPointsFactor (const OrientedPointSamplingParameters& parameters);

} // namespace pcl_ops::internal
