// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud/points.h"

namespace pcl_ops::internal {

/** \brief The distinct positions of a cloud, sorted along a space-filling curve:
 * successive positions are near each other. The order depends on coordinates alone.
 * Equal points count once: drivers write missing readings as zeros, and data sets
 * repeat points. */
struct DistinctPlaces : Coordinates {
  /** \brief For each point of the input the index of its position here. */
  Indices of_input;
};

/** \param[in] positions finite points */
DistinctPlaces
distinctPlaces (const Coordinates& positions, unsigned threads);

} // namespace pcl_ops::internal
