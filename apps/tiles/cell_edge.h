// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "plan.h"

#include <cstdint>
#include <vector>

namespace pcl_ops::apps {

/** \brief Of places of each input so many that all inputs are as densely sampled. */
std::vector<Eigen::Vector3d>
evenSample (const std::vector<std::vector<Eigen::Vector3d>>& places, const Plan& plan);

/** \brief Edge of cells that hold about 20 points where a surface is: by the density of
 * the points and not by their number. Measured on simulated surveys: larger cells miss
 * planes, smaller ones cost more. Rounded to two digits.
 * \param[in] places spread evenly over the points, most of them at one place or not
 * \param[in] zero near most of them
 * \param[in] points of the whole */
double
cellEdgeFor (std::vector<Eigen::Vector3d> places,
             const Eigen::Vector3d& zero,
             std::uint64_t points);

} // namespace pcl_ops::apps
