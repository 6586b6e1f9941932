// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/detection_report.h>

#include <vector>

namespace pcl_ops::internal {

/** \brief The value below which a share of the values lies; 0 for no values. Reorders.
 */
float
quantileOf (std::vector<float>& values, double share);

/** \brief Sets what is usual of a cloud in which places of these densities [1/m^2] have
 * this noise [m]: those that tell. */
void
setUsualNoise (const std::vector<float>& density,
               const std::vector<float>& noise,
               CloudNoise& cloud);

/** \brief What places of a density scatter by in the median [m], interpolated between
 * octaves: a density between two of them has something of both, so that no small change
 * of a cloud is a large one here. 0 where no place tells. */
double
usualNoise (const CloudNoise& cloud, double density);

} // namespace pcl_ops::internal
