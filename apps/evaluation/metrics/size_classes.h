// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "confusion.h"

#include <optional>

namespace pcl_ops::evaluation {

/** \brief True planes of about the same number of points, and how many are found. */
struct SizeClass {
  std::size_t fewest_points = 0;
  /** \brief The class above begins here; none for the largest planes. */
  std::optional<std::size_t> below;
  std::size_t planes = 0;
  /** \brief Matched at an intersection over union of 0.5, see \ref instanceMetrics. */
  std::size_t found_50 = 0;
  /** \brief The same at 0.75. */
  std::size_t found_75 = 0;
};

/** \brief True planes by number of points, smallest first: below 200, 500, 1000, 3000,
 * 10000, and more. */
std::vector<SizeClass>
sizeClasses (const Confusion& confusion);

} // namespace pcl_ops::evaluation
