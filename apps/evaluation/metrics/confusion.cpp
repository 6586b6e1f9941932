// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "confusion.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <unordered_map>
#include <utility>

namespace pcl_ops::evaluation {

namespace {

using Index = Eigen::Index;
constexpr Index none = -1;

/** The cheapest pairing of all rows, of which there are no more than columns. */
std::vector<std::ptrdiff_t>
rowsOfColumns (const Eigen::MatrixXd& cost)
{
  const Index columns = cost.cols();
  Eigen::VectorXd row_price = Eigen::VectorXd::Zero (cost.rows());
  Eigen::VectorXd column_price = Eigen::VectorXd::Zero (columns + 1);
  // Behind the last column stands the row that is added.
  std::vector<std::ptrdiff_t> row_of (columns + 1, none), previous (columns);
  for (std::ptrdiff_t& row = row_of[columns] = 0; row < cost.rows(); ++row) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Eigen::VectorXd slack = Eigen::VectorXd::Constant (columns, infinity);
    std::vector<bool> is_settled (columns + 1, false);
    Index column = columns;
    // The cheapest alternating path from the row to a free column (Dijkstra); prices
    // keep every reduced cost non-negative and those of pairs at zero.
    while (row_of[column] != none) {
      is_settled[column] = true;
      const Index settled = std::exchange (column, none), its_row = row_of[settled];
      for (Index other = 0; other < columns; ++other) {
        const double reduced =
            cost (its_row, other) - row_price[its_row] - column_price[other];
        if (!is_settled[other] && reduced < slack[other]) {
          slack[other] = reduced;
          previous[other] = settled;
        }
        if (!is_settled[other] && (column == none || slack[other] < slack[column]))
          column = other;
      }
      const double step = slack[column];
      slack.array() -= step;
      for (Index other = 0; other <= columns; ++other)
        if (is_settled[other]) {
          row_price[row_of[other]] += step;
          column_price[other] -= step;
        }
    }
    for (; column != columns; column = previous[column])
      row_of[column] = row_of[previous[column]];
  }
  row_of.pop_back();
  return row_of;
}

} // namespace

Confusion
confusionOf (const PlaneLabels& truth, const PlaneLabels& result)
{
  Confusion confusion{planeIds (truth), planeIds (result), {}, truth.size(), 0, 0};
  const std::uint64_t columns = confusion.result.size();
  std::unordered_map<std::uint64_t, std::size_t> points_of_pair;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    confusion.points_off_planes += truth[i] == 0;
    if (truth[i] == 0 && result[i] == 0)
      ++confusion.points_on_no_plane_in_both;
    else if (truth[i] != 0 && result[i] != 0)
      ++points_of_pair[confusion.truth.of_point[i] * columns +
                       confusion.result.of_point[i]];
  }
  for (const auto& [pair, points] : points_of_pair)
    confusion.overlaps.push_back ({static_cast<std::uint32_t> (pair / columns),
                                   static_cast<std::uint32_t> (pair % columns),
                                   points});
  std::sort (confusion.overlaps.begin(),
             confusion.overlaps.end(),
             [] (const Overlap& a, const Overlap& b) {
               return a.truth != b.truth ? a.truth < b.truth : a.result < b.result;
             });
  return confusion;
}

std::vector<std::ptrdiff_t>
maximumAssignment (const Eigen::MatrixXd& benefit)
{
  const bool is_turned = benefit.rows() > benefit.cols();
  const std::vector<std::ptrdiff_t> row_of = rowsOfColumns (
      is_turned ? Eigen::MatrixXd (-benefit.transpose()) : Eigen::MatrixXd (-benefit));
  if (is_turned)
    return row_of;
  std::vector<std::ptrdiff_t> column_of (benefit.rows(), none);
  for (std::size_t column = 0; column < row_of.size(); ++column)
    if (row_of[column] != none)
      column_of[row_of[column]] = static_cast<std::ptrdiff_t> (column);
  return column_of;
}

std::size_t
pointsOfAssignment (const Confusion& confusion)
{
  // 0.8 GB of matrix; no cloud has that many planes, only a wrong label field does.
  constexpr std::size_t max_plane_pairs = 100'000'000;
  if (confusion.truth.size() * confusion.result.size() > max_plane_pairs)
    throw std::length_error (std::to_string (confusion.truth.size()) + " and " +
                             std::to_string (confusion.result.size()) +
                             " labels are too many for planes");
  Eigen::MatrixXd common =
      Eigen::MatrixXd::Zero (confusion.truth.size(), confusion.result.size());
  for (const Overlap& overlap : confusion.overlaps)
    common (overlap.truth, overlap.result) = static_cast<double> (overlap.points);
  const std::vector<std::ptrdiff_t> result_of = maximumAssignment (common);
  std::size_t points = 0;
  for (const Overlap& overlap : confusion.overlaps)
    if (result_of[overlap.truth] == static_cast<std::ptrdiff_t> (overlap.result))
      points += overlap.points;
  return points;
}

} // namespace pcl_ops::evaluation
