// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud/points.h"
#include <pcl_ops/plane.h>

#include <vector>

namespace pcl_ops::internal {

/** \brief Makes two planes of those that are two layers: the sides of a thin wall are
 * neighbors and come out as one plane. Where a threshold on the signed distances of a
 * plane's points explains most of their variance, what lies above it is another plane
 * (Otsu's threshold; N. Otsu, "A Threshold Selection Method from Gray-Level
 * Histograms", IEEE Trans. Systems, Man, and Cybernetics, 1979).
 * \param[in] min_apart of each plane: layers nearer to each other are one [m]
 * \param[in,out] labels of the points; new planes are numbered from \p is_kept.size()
 * \param[in,out] is_kept planes that are kept, new ones are added
 * \return whether any plane has layers */
bool
splitLayers (const Coordinates& points,
             const std::vector<Plane>& planes,
             const std::vector<double>& min_apart,
             Labels& labels,
             std::vector<char>& is_kept);

} // namespace pcl_ops::internal
