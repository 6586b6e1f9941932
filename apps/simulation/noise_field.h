// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <base/random.h>

#include <vector>

namespace pcl_ops::simulation {

/** \brief A standard normal value for each pixel, row by row, each by itself. */
std::vector<double>
drawWhiteField (int width, int height, internal::RandomGenerator& generator);

/** \brief A standard normal value for each pixel, alike for neighbours: white noise
 * filtered by a Gaussian and brought back to variance 1.
 *
 * \param[in] width,height of the image [px]
 * \param[in] smoothing standard deviation s of the filter [px]; at a distance d the
 * correlation is exp (-d^2 / (4 s^2))
 * \param[in,out] generator source of the white noise */
std::vector<double>
drawSmoothField (int width,
                 int height,
                 double smoothing,
                 internal::RandomGenerator& generator);

} // namespace pcl_ops::simulation
