// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud/points.h"

namespace pcl_ops::internal {

/** \brief The different points of a cloud in an order that their coordinates alone
 * decide, along a space-filling curve: those that follow each other are near each
 * other. Equal points count once: drivers write missing readings as zeros, and data
 * sets draw points more than once. */
struct DistinctPlaces : Coordinates {
  /** \brief Which of these places each point of the cloud is at. */
  Indices of_input;
};

/** \param[in] positions finite points */
DistinctPlaces
distinctPlaces (const Coordinates& positions, unsigned threads);

} // namespace pcl_ops::internal
