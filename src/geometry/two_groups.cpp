// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/two_groups.h"

#include <cmath>

namespace pcl_ops::internal {

TwoGroups
bestTwoGroups (const std::vector<double>& sorted, std::size_t min_of_group)
{
  double sum = 0.0;
  double sum_of_squares = 0.0;
  for (const double value : sorted) {
    sum += value;
    sum_of_squares += value * value;
  }
  const auto count = static_cast<double> (sorted.size());
  std::size_t first_above = 0;
  double apart = 0.0;
  double largest_squares_between = 0.0; // sum of squares between the groups
  double sum_below = 0.0;               // of the values of the lower group
  for (std::size_t i = 1; i + min_of_group <= sorted.size(); ++i) {
    sum_below += sorted[i - 1];
    if (i < min_of_group)
      continue;
    const auto below = static_cast<double> (i); // number of values in the lower group
    const double means_apart = sum_below / below - (sum - sum_below) / (count - below);
    const double squares_between =
        below * (count - below) / count * means_apart * means_apart;
    if (squares_between > largest_squares_between) {
      largest_squares_between = squares_between;
      first_above = i;
      apart = std::abs (means_apart);
    }
  }
  const double squares_about_mean = sum_of_squares - sum * sum / count;
  return squares_about_mean > 0.0
             ? TwoGroups{first_above,
                         apart,
                         largest_squares_between / squares_about_mean}
             : TwoGroups{}; // the values are equal but for rounding
}

} // namespace pcl_ops::internal
