// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "confusion.h"
#include <evaluation/labels/plane_classes.h>

#include <optional>
#include <sstream>
#include <string>

namespace pcl_ops::evaluation {

/** \brief True planes of about the same size, and how many are found.
 * \tparam Size a number of points, or a width [m] */
template <typename Size>
struct SizeClass {
  Size from{};
  /** \brief The class above begins here; none for the largest planes. */
  std::optional<Size> below;
  std::size_t planes = 0;
  /** \brief Matched at an intersection over union of 0.5, see \ref instanceMetrics. */
  std::size_t found_50 = 0;
  /** \brief The same at 0.75. */
  std::size_t found_75 = 0;
};

using PointsClass = SizeClass<std::size_t>;
using WidthClass = SizeClass<double>;

/** \brief True planes by number of points, smallest first: below 200, 500, 1000, 3000,
 * 10000, and more. */
std::vector<PointsClass>
sizeClasses (const Confusion& confusion);

/** \brief True planes by width, narrowest first: below 0.03, 0.06, 0.12, 0.25, 1 m, and
 * wider.
 * \param[in] confusion of labellings
 * \param[in] widths of its true planes [m] */
std::vector<WidthClass>
widthClasses (const Confusion& confusion, const std::vector<double>& widths);

/** \brief The smaller side of each plane: of the rectangle whose points, spread evenly,
 * have the variance of the plane's along its second axis, sqrt (12 variance). 0 where
 * the points span no plane. A plane that is partly hidden is as wide as what is seen of
 * it.
 * \param[in] cloud finite points
 * \param[in] planes ids of their labels */
std::vector<double>
widthsOf (const XyzCloud& cloud, const PlaneIds& planes);

/** \brief "below 0.03", and "from 1" for the last class. */
template <typename Size>
std::string
rangeName (const SizeClass<Size>& size, char between = ' ')
{
  std::ostringstream name;
  name << (size.below ? "below" : "from") << between << size.below.value_or (size.from);
  return name.str();
}

/** \brief Under which the counts of a class are published. */
struct CountNames {
  std::string planes, found_50, found_75;
};

/** \brief As in "found_75_by_width_below_0.03". */
template <typename Size>
CountNames
countNames (const std::string& by, const SizeClass<Size>& size)
{
  const std::string suffix = "_by_" + by + '_' + rangeName (size, '_');
  return {"planes" + suffix, "found" + suffix, "found_75" + suffix};
}

} // namespace pcl_ops::evaluation
