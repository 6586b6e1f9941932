// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "hungarian.h"

#include <limits>

namespace pcl_ops::evaluation {

namespace {

using Index = Eigen::Index;
constexpr Index unassigned = -1;

/** Dual variables and the pairing they prove optimal for the rows added so far. */
struct Assignment {
  const Eigen::MatrixXd& cost;
  Eigen::VectorXd row_price = Eigen::VectorXd::Zero (cost.rows());
  Eigen::VectorXd column_price = Eigen::VectorXd::Zero (cost.cols());
  std::vector<Index> row_of = std::vector<Index> (cost.cols(), unassigned);

  double
  reducedCost (Index row, Index column) const
  {
    return cost (row, column) - row_price[row] - column_price[column];
  }
};

/** The tree of cheapest alternating paths from one unassigned row (Dijkstra). */
struct PathTree {
  Eigen::VectorXd length;
  std::vector<Index> previous_column;
  std::vector<Index> settled;
  std::vector<bool> is_settled;

  explicit PathTree (Index columns)
  : length (
        Eigen::VectorXd::Constant (columns, std::numeric_limits<double>::infinity()))
  , previous_column (columns, unassigned)
  , is_settled (columns, false)
  {}

  Index
  nearestOpenColumn () const
  {
    Index nearest = unassigned;
    for (Index column = 0; column < length.size(); ++column)
      if (!is_settled[column] &&
          (nearest == unassigned || length[column] < length[nearest]))
        nearest = column;
    return nearest;
  }
};

/** Grows the tree until it reaches a free column, which ends the path. */
Index
findFreeColumn (const Assignment& assignment, Index start_row, PathTree& tree)
{
  Index row = start_row, last_column = unassigned;
  double length_so_far = 0.0;
  while (true) {
    for (Index column = 0; column < tree.length.size(); ++column) {
      const double length = length_so_far + assignment.reducedCost (row, column);
      if (!tree.is_settled[column] && length < tree.length[column]) {
        tree.length[column] = length;
        tree.previous_column[column] = last_column;
      }
    }
    last_column = tree.nearestOpenColumn();
    if (assignment.row_of[last_column] == unassigned)
      return last_column;
    tree.is_settled[last_column] = true;
    tree.settled.push_back (last_column);
    length_so_far = tree.length[last_column];
    row = assignment.row_of[last_column];
  }
}

void
addRow (Assignment& assignment, Index row)
{
  PathTree tree (assignment.cost.cols());
  const Index free_column = findFreeColumn (assignment, row, tree);
  const double path_length = tree.length[free_column];
  // New prices keep every reduced cost non-negative and those of pairs at zero.
  assignment.row_price[row] += path_length;
  for (const Index column : tree.settled) {
    const double slack = path_length - tree.length[column];
    assignment.row_price[assignment.row_of[column]] += slack;
    assignment.column_price[column] -= slack;
  }
  for (Index column = free_column; column != unassigned;) {
    const Index previous = tree.previous_column[column];
    assignment.row_of[column] =
        previous == unassigned ? row : assignment.row_of[previous];
    column = previous;
  }
}

} // namespace

std::vector<std::ptrdiff_t>
maximumAssignment (const Eigen::MatrixXd& benefit)
{
  const bool wide = benefit.rows() <= benefit.cols();
  const Eigen::MatrixXd cost =
      wide ? Eigen::MatrixXd (-benefit) : Eigen::MatrixXd (-benefit.transpose());
  Assignment assignment{cost};
  for (Index row = 0; row < cost.rows(); ++row)
    addRow (assignment, row);

  if (!wide)
    return {assignment.row_of.begin(), assignment.row_of.end()};
  std::vector<std::ptrdiff_t> column_of (benefit.rows(), unassigned);
  for (Index column = 0; column < cost.cols(); ++column)
    if (assignment.row_of[column] != unassigned)
      column_of[assignment.row_of[column]] = column;
  return column_of;
}

} // namespace pcl_ops::evaluation
