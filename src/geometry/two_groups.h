// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace pcl_ops::internal {

/** \brief Sorted values as a lower and an upper group. */
struct TwoGroups {
  std::size_t first_above = 0;
  double apart = 0.0; // distance of the means of both
  /** \brief Sum of squares of these means about the mean of all, as a share of that of
   * the values: 1 where each group is a single value. The best division of a normal
   * distribution has .64, of an even one .75. */
  double explained_share = 0.0;
};

/** \brief The division that explains most (N. Otsu, "A Threshold Selection Method from
 * Gray-Level Histograms", IEEE Trans. Systems, Man, and Cybernetics, 1979).
 * \param[in] sorted rising values
 * \param[in] min_of_group values that a group has at least, 1 or more; all zero without
 * a division that has so many */
TwoGroups
bestTwoGroups (const std::vector<double>& sorted, std::size_t min_of_group = 1);

} // namespace pcl_ops::internal
