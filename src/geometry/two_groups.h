// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace pcl_ops::internal {

/** \brief A division of sorted values into a lower and an upper group. */
struct TwoGroups {
  /** \brief Index of the first value of the upper group. */
  std::size_t first_above = 0;
  /** \brief Distance between the means of both groups, in the unit of the values. */
  double apart = 0.0;
  /** \brief Between-group sum of squares over the total sum of squares: 1 if the values
   * of each group are equal. The best division of a normal distribution has .64, that
   * of a uniform distribution .75. */
  double explained_share = 0.0;
};

/** \brief Finds the division with the largest explained share (N. Otsu, "A Threshold
 * Selection Method from Gray-Level Histograms", IEEE Trans. Systems, Man, and
 * Cybernetics, 1979).
 * \param[in] sorted values in ascending order
 * \param[in] min_of_group smallest number of values in a group, 1 or more
 * \return all members 0 if the values are equal or too few for two groups */
TwoGroups
bestTwoGroups (const std::vector<double>& sorted, std::size_t min_of_group = 1);

} // namespace pcl_ops::internal
