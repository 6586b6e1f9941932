// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <evaluation/metrics/hungarian.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace {

using pcl_ops::evaluation::maximumAssignment;
using Columns = std::vector<std::ptrdiff_t>;

double
benefitOf (const Eigen::MatrixXd& benefit, const Columns& column_of)
{
  double sum = 0.0;
  for (std::size_t row = 0; row < column_of.size(); ++row)
    sum += column_of[row] < 0 ? 0.0 : benefit (row, column_of[row]);
  return sum;
}

/** Tries all permutations of the columns; only for at least as many columns as rows. */
double
bestByBruteForce (const Eigen::MatrixXd& benefit)
{
  Columns columns (benefit.cols());
  std::iota (columns.begin(), columns.end(), 0);
  double best = -1e9;
  do
    best = std::max (
        best, benefitOf (benefit, {columns.begin(), columns.begin() + benefit.rows()}));
  while (std::next_permutation (columns.begin(), columns.end()));
  return best;
}

TEST (Hungarian, IsTheBestOfAllPermutationsWhateverTheShape)
{
  std::mt19937 generator (1);
  for (const auto& [rows, columns] : {std::pair (5, 5), {3, 6}, {6, 3}})
    for (int i = 0; i < 50; ++i) {
      const Eigen::MatrixXd benefit = Eigen::MatrixXd::NullaryExpr (
          rows, columns, [&] { return double (generator() % 20) - 5.0; });
      const Eigen::MatrixXd turned = benefit.transpose();
      EXPECT_EQ (benefitOf (benefit, maximumAssignment (benefit)),
                 bestByBruteForce (rows > columns ? turned : benefit));
    }
}

TEST (Hungarian, NothingToAssignIsNoError)
{
  EXPECT_TRUE (maximumAssignment (Eigen::MatrixXd (0, 4)).empty());
  EXPECT_EQ (maximumAssignment (Eigen::MatrixXd (2, 0)), (Columns{-1, -1}));
}

} // namespace
