// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "confusion.h"
#include <evaluation/labels/labels.h>

#include <optional>
#include <string>

namespace pcl_ops::evaluation {

/** \brief True planes of about the same size, a number of points or a width [m], and
 * how many are found. */
struct SizeClass {
  double from = 0.0;
  /** \brief The class above begins here; none for the largest planes. */
  std::optional<double> below;
  std::size_t planes = 0;
  /** \brief Matched at an intersection over union of 0.5, see \ref instanceMetrics. */
  std::size_t found_50 = 0;
  /** \brief The same at 0.75. */
  std::size_t found_75 = 0;

  /** \brief "below 0.03", and "from 1" for the last class. */
  std::string
  name (char between = ' ') const;
};

using SizeClasses = std::vector<SizeClass>;

/** \brief True planes by number of points, smallest first: below 200, 500, 1000, 3000,
 * 10000, and more. */
SizeClasses
sizeClasses (const Confusion& confusion);

/** \brief True planes by width, narrowest first: below 0.03, 0.06, 0.12, 0.25, 1 m, and
 * wider.
 * \param[in] confusion of labelings
 * \param[in] widths of its true planes [m] */
SizeClasses
widthClasses (const Confusion& confusion, const std::vector<double>& widths);

/** \brief The smaller side of each plane: of the rectangle whose points, spread evenly,
 * have the variance of the plane's along its second axis, sqrt (12 variance). 0 where
 * the points span no plane. A plane that is partly hidden is as wide as what is seen of
 * it.
 * \param[in] cloud finite points
 * \param[in] planes ids of their labels */
std::vector<double>
widthsOf (const XyzCloud& cloud, const PlaneIds& planes);

} // namespace pcl_ops::evaluation
