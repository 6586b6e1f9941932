// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace pcl_ops::apps {

/** \brief Returns part / whole, or \p of_nothing if whole is 0. */
inline double
fraction (std::size_t part, std::size_t whole, double of_nothing)
{
  return whole == 0 ? of_nothing
                    : static_cast<double> (part) / static_cast<double> (whole);
}

/** \brief Returns the smallest value such that at least this share, 0 to 1, of all
 * values are not larger; share 0.5 gives the median, of an even number of values the
 * lower one. NaN if there are no values. */
template <typename Number>
Number
quantile (std::vector<Number> values, double share)
{
  if (values.empty())
    return std::numeric_limits<Number>::quiet_NaN();
  // Its position in the sorted values, counted from 1.
  const double rank = std::ceil (share * static_cast<double> (values.size()));
  const auto wanted =
      values.begin() + static_cast<std::ptrdiff_t> (std::max (rank, 1.0)) - 1;
  std::nth_element (values.begin(), wanted, values.end());
  return *wanted;
}

/** \brief Returns the vector whose coordinates are the \ref quantile of the coordinates
 * of the points along each axis.
 * \tparam Vector of Eigen, with a fixed size */
template <typename Vector>
Vector
quantileOfEach (const std::vector<Vector>& points, double share)
{
  Vector quantiles;
  for (int axis = 0; axis < quantiles.size(); ++axis) {
    std::vector<typename Vector::Scalar> coordinates;
    for (const Vector& point : points)
      coordinates.push_back (point[axis]);
    quantiles[axis] = quantile (std::move (coordinates), share);
  }
  return quantiles;
}

} // namespace pcl_ops::apps
