// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <metrics/assignment.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

namespace {

using pcl_ops::evaluation::maximumAssignment;

TEST (Assignment, IsTheBestOfAllPermutationsOfTheColumns)
{
  std::mt19937 generator (1);
  for (const auto& [rows, columns] : {std::pair (5, 5), {3, 6}, {0, 4}, {0, 0}})
    for (int i = 0; i < 50; ++i) {
      // Whole numbers from -5 to 14.
      const Eigen::MatrixXd benefit = Eigen::MatrixXd::NullaryExpr (
          rows, columns, [&] { return double (generator() % 20) - 5.0; });
      std::vector<int> column_of_row (columns); // those after the last row stay free
      std::iota (column_of_row.begin(), column_of_row.end(), 0);
      double best = -std::numeric_limits<double>::infinity();
      do {
        double sum = 0.0;
        for (int row = 0; row < rows; ++row)
          sum += benefit (row, column_of_row[row]);
        best = std::max (best, sum);
      }
      while (std::next_permutation (column_of_row.begin(), column_of_row.end()));
      EXPECT_EQ (maximumAssignment (benefit), best);
    }
}

} // namespace
