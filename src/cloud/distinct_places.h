// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud/points.h"

namespace pcl_ops::internal {

/** \brief The distinct places of a cloud: the positions of its points, equal positions
 * only once. Points are equal because drivers write missing readings as zeros, and data
 * sets repeat points. The places are sorted along a space-filling curve: successive
 * ones are near each other, unless an outlier makes the cells of the curve large. Their
 * order depends on coordinates alone. */
struct DistinctPlaces : Coordinates {
  /** \brief For each point of the cloud the index of its place. */
  Indices of_input;
};

/** \brief Returns the distinct places of points.
 * \param[in] points finite points
 * \param[in] threads largest number of threads; 0: one for each processor */
DistinctPlaces
distinctPlaces (const Coordinates& points, unsigned threads);

} // namespace pcl_ops::internal
