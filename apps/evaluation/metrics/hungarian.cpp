// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "hungarian.h"

#include <limits>

namespace pcl_ops::evaluation {

namespace {

using Index = Eigen::Index;
constexpr Index none = -1;

/** Dual variables and the pairing they prove optimal for the rows added so far. */
struct Assignment {
  const Eigen::MatrixXd& cost;
  Eigen::VectorXd row_price = Eigen::VectorXd::Zero (cost.rows());
  Eigen::VectorXd column_price = Eigen::VectorXd::Zero (cost.cols());
  std::vector<Index> row_of = std::vector<Index> (cost.cols(), none);

  void
  addRow (Index start)
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Eigen::VectorXd length = Eigen::VectorXd::Constant (cost.cols(), infinity);
    std::vector<Index> previous (cost.cols(), none), settled;
    std::vector<bool> is_settled (cost.cols(), false);
    Index row = start, last = none;
    double so_far = 0.0;
    // The cheapest alternating path from the row to a free column (Dijkstra).
    while (row != none) {
      Index nearest = none;
      for (Index column = 0; column < cost.cols(); ++column) {
        if (is_settled[column])
          continue;
        const double through =
            so_far + cost (row, column) - row_price[row] - column_price[column];
        if (through < length[column]) {
          length[column] = through;
          previous[column] = last;
        }
        if (nearest == none || length[column] < length[nearest])
          nearest = column;
      }
      last = nearest;
      row = row_of[last];
      so_far = length[last];
      is_settled[last] = true;
      if (row != none)
        settled.push_back (last);
    }
    // New prices keep every reduced cost non-negative and those of pairs at zero.
    row_price[start] += so_far;
    for (const Index column : settled) {
      row_price[row_of[column]] += so_far - length[column];
      column_price[column] -= so_far - length[column];
    }
    for (Index column = last; column != none; column = previous[column])
      row_of[column] = previous[column] == none ? start : row_of[previous[column]];
  }
};

} // namespace

std::vector<std::ptrdiff_t>
maximumAssignment (const Eigen::MatrixXd& benefit)
{
  const bool wide = benefit.rows() <= benefit.cols();
  const Eigen::MatrixXd cost =
      wide ? Eigen::MatrixXd (-benefit) : Eigen::MatrixXd (-benefit.transpose());
  Assignment assignment{cost};
  for (Index row = 0; row < cost.rows(); ++row)
    assignment.addRow (row);

  if (!wide)
    return {assignment.row_of.begin(), assignment.row_of.end()};
  std::vector<std::ptrdiff_t> column_of (benefit.rows(), none);
  for (Index column = 0; column < cost.cols(); ++column)
    if (assignment.row_of[column] != none)
      column_of[assignment.row_of[column]] = column;
  return column_of;
}

} // namespace pcl_ops::evaluation
