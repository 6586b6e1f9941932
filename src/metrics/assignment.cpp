// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "assignment.h"

#include <limits>
#include <vector>

namespace pcl_ops::evaluation {

namespace {

using Index = Eigen::Index;
constexpr Index none = -1;

/** The assigned pairs of the rows added so far, and prices (dual variables) that prove
 * them optimal. The cost of a pair is its negative benefit, its reduced cost is this
 * less the prices of row and column. The reduced cost is zero for each assigned pair,
 * and not negative for any other pair. */
struct Assignment {
  explicit Assignment (const Eigen::MatrixXd& all_benefits)
  : benefit (all_benefits)
  , row_price (Eigen::VectorXd::Zero (all_benefits.rows()))
  , column_price (Eigen::VectorXd::Zero (all_benefits.cols()))
  , row_of_column (std::size_t (all_benefits.cols()), none)
  {}

  double
  reducedCost (Index row, Index column) const
  {
    return -benefit (row, column) - row_price[row] - column_price[column];
  }

  double
  sumOfBenefits () const
  {
    double sum = 0.0;
    for (Index column = 0; column < benefit.cols(); ++column)
      if (row_of_column[column] != none)
        sum += benefit (row_of_column[column], column);
    return sum;
  }

  const Eigen::MatrixXd& benefit;
  Eigen::VectorXd row_price;
  Eigen::VectorXd column_price;
  /** For each column the row assigned to it, or none. */
  std::vector<Index> row_of_column;
};

/** The shortest alternating paths from an unassigned row to all columns (Dijkstra):
 * from a row to any column, and from a column to the row assigned to it. */
struct PathTree {
  explicit PathTree (Index columns)
  : length (
        Eigen::VectorXd::Constant (columns, std::numeric_limits<double>::infinity()))
  , previous (std::size_t (columns), none)
  , is_settled (std::size_t (columns), false)
  {}

  /** Returns the column with the shortest path of those that are not settled; none if
   * all are settled. */
  Index
  nearestUnsettledColumn () const
  {
    Index nearest = none;
    for (Index column = 0; column < length.size(); ++column)
      if (!is_settled[column] && (nearest == none || length[column] < length[nearest]))
        nearest = column;
    return nearest;
  }

  /** For each column the length of its path so far: a sum of reduced costs. */
  Eigen::VectorXd length;
  /** For each column the column before it on its path; none for the first column. */
  std::vector<Index> previous;
  /** For each column whether its path is final. */
  std::vector<bool> is_settled;
  /** The columns whose paths are final. */
  std::vector<Index> settled = {};
};

/** Extends a path by one step to each column that is not settled.
 * \param[in] row end of the path
 * \param[in] last_column last column of the path, none if the path is only \p row
 * \param[in] length_so_far of the path */
void
relaxColumns (const Assignment& assignment,
              Index row,
              Index last_column,
              double length_so_far,
              PathTree& tree)
{
  for (Index column = 0; column < tree.length.size(); ++column) {
    if (tree.is_settled[column])
      continue;
    const double length = length_so_far + assignment.reducedCost (row, column);
    if (length < tree.length[column]) {
      tree.length[column] = length;
      tree.previous[column] = last_column;
    }
  }
}

/** Grows the tree from an unassigned row until it reaches the nearest unassigned
 * column; returns this column. */
Index
findFreeColumn (const Assignment& assignment, Index start_row, PathTree& tree)
{
  relaxColumns (assignment, start_row, none, 0.0, tree);
  Index column = tree.nearestUnsettledColumn();
  while (assignment.row_of_column[column] != none) {
    tree.is_settled[column] = true;
    tree.settled.push_back (column);
    relaxColumns (assignment,
                  assignment.row_of_column[column],
                  column,
                  tree.length[column],
                  tree);
    column = tree.nearestUnsettledColumn();
  }
  return column;
}

/** Augments along the path to \p end: each column takes the row of the column before
 * it, and the first column takes the new row. */
void
shiftPairs (Assignment& assignment, const PathTree& tree, Index end, Index new_row)
{
  Index column = end;
  while (tree.previous[column] != none) {
    const Index previous = tree.previous[column];
    assignment.row_of_column[column] = assignment.row_of_column[previous];
    column = previous;
  }
  assignment.row_of_column[column] = new_row;
}

/** Assigns one more row, and changes prices so that they prove the new pairs optimal.
 */
void
addRow (Assignment& assignment, Index row)
{
  PathTree tree (assignment.benefit.cols());
  const Index free_column = findFreeColumn (assignment, row, tree);
  const double path_length = tree.length[free_column];
  assignment.row_price[row] += path_length;
  for (const Index column : tree.settled) {
    const double slack = path_length - tree.length[column];
    assignment.row_price[assignment.row_of_column[column]] += slack;
    assignment.column_price[column] -= slack;
  }
  shiftPairs (assignment, tree, free_column, row);
}

} // namespace

double
maximumAssignment (const Eigen::MatrixXd& benefit)
{
  Assignment assignment (benefit);
  for (Index row = 0; row < benefit.rows(); ++row)
    addRow (assignment, row);
  return assignment.sumOfBenefits();
}

} // namespace pcl_ops::evaluation
