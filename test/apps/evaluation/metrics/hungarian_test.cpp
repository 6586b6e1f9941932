// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <evaluation/metrics/hungarian.h>
#include <numbers/random.h>

#include <algorithm>
#include <numeric>
#include <set>

namespace {

using pcl_ops::evaluation::maximumAssignment;

Eigen::MatrixXd
randomBenefit (Eigen::Index rows, Eigen::Index columns, std::uint32_t seed)
{
  pcl_ops::apps::Random random (seed);
  return Eigen::MatrixXd::NullaryExpr (
      rows, columns, [&] { return double (random.below (20)) - 5.0; });
}

double
benefitOf (const Eigen::MatrixXd& benefit, const std::vector<std::ptrdiff_t>& column_of)
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
  std::vector<std::ptrdiff_t> columns (benefit.cols());
  std::iota (columns.begin(), columns.end(), 0);
  double best = -1e9;
  do
    best = std::max (
        best, benefitOf (benefit, {columns.begin(), columns.begin() + benefit.rows()}));
  while (std::next_permutation (columns.begin(), columns.end()));
  return best;
}

TEST (Hungarian, MatchesAllPermutationsOfFiveByFive)
{
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    const Eigen::MatrixXd benefit = randomBenefit (5, 5, seed);
    EXPECT_EQ (benefitOf (benefit, maximumAssignment (benefit)),
               bestByBruteForce (benefit));
  }
}

TEST (Hungarian, LeavesColumnsOverWhereThereAreMore)
{
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    const Eigen::MatrixXd benefit = randomBenefit (3, 6, seed);
    EXPECT_EQ (benefitOf (benefit, maximumAssignment (benefit)),
               bestByBruteForce (benefit));
  }
}

TEST (Hungarian, LeavesRowsOverWhereThereAreMore)
{
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    const Eigen::MatrixXd benefit = randomBenefit (6, 3, seed);
    EXPECT_EQ (benefitOf (benefit, maximumAssignment (benefit)),
               bestByBruteForce (benefit.transpose()));
  }
}

TEST (Hungarian, FindsAPermutationHiddenInAnotherwiseSmallerLargeMatrix)
{
  constexpr Eigen::Index size = 300;
  Eigen::MatrixXd benefit = randomBenefit (size, size, 300);
  for (Eigen::Index row = 0; row < size; ++row)
    benefit (row, (7 * row + 3) % size) = 1000.0; // 7 and 300 have no common divisor
  const std::vector<std::ptrdiff_t> column_of = maximumAssignment (benefit);
  for (Eigen::Index row = 0; row < size; ++row)
    EXPECT_EQ (column_of[row], (7 * row + 3) % size);
}

/** Machol-Wien: benefit -(i+1)(j+1), whose optimum pairs i with n-1-i; a classic hard
 * case of the method. */
TEST (Hungarian, SolvesTheLargeProductMatrix)
{
  constexpr Eigen::Index size = 200;
  const Eigen::MatrixXd benefit =
      Eigen::MatrixXd::NullaryExpr (size, size, [] (Eigen::Index i, Eigen::Index j) {
        return -double ((i + 1) * (j + 1));
      });
  const std::vector<std::ptrdiff_t> column_of = maximumAssignment (benefit);
  for (Eigen::Index row = 0; row < size; ++row)
    EXPECT_EQ (column_of[row], size - 1 - row);
}

TEST (Hungarian, GivesTheGreedyChoiceUpWhereTheSumIsLarger)
{
  const Eigen::MatrixXd benefit = (Eigen::MatrixXd (2, 2) << 10, 9, 9, 0).finished();
  EXPECT_EQ (maximumAssignment (benefit), (std::vector<std::ptrdiff_t>{1, 0}));
}

TEST (Hungarian, NothingToAssignIsNoError)
{
  EXPECT_TRUE (maximumAssignment (Eigen::MatrixXd (0, 4)).empty());
  EXPECT_EQ (maximumAssignment (Eigen::MatrixXd (2, 0)),
             (std::vector<std::ptrdiff_t>{-1, -1}));
}

} // namespace
