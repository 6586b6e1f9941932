// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "leaves/common_errors.h"

#include <algorithm>
#include <cmath>

namespace pcl_ops::internal {

namespace {

// Whether a cell's points lie on a plane but for rounding.
bool
isExact (const CellScatter& cell, double finest_cell)
{
  constexpr double rounding = 1e-3; // of the edge of a cell
  return cell.is_wide && cell.noise < rounding * std::ldexp (finest_cell, cell.level);
}

// Calls a function with the number of each leaf in a cell.
template <typename Function>
void
forLeavesIn (const CellScatter& cell,
             const std::vector<Leaf>& leaves,
             const Function& function)
{
  const auto first = std::lower_bound (
      leaves.begin(),
      leaves.end(),
      cell.begin,
      [] (const Leaf& leaf, std::uint32_t begin) { return leaf.begin < begin; });
  for (auto leaf = first; leaf != leaves.end() && leaf->begin < cell.begin + cell.count;
       ++leaf)
    function (static_cast<std::size_t> (leaf - leaves.begin()));
}

// Leaves that are exact planes, in a cell of twice the edge that is not: one step of a
// quantized depth. In a CAD model without noise larger cells are exact, too.
std::vector<char>
leavesOnSteps (const std::vector<CellScatter>& cells,
               const std::vector<Leaf>& leaves,
               double finest_cell)
{
  int largest_level = 0;
  for (const Leaf& leaf : leaves)
    largest_level = std::max (largest_level, leaf.level);
  std::vector<char> is_exact (leaves.size(), 0);
  std::vector<char> is_on_step (leaves.size(), 0);
  // A cell follows those that it holds.
  for (const CellScatter& cell : cells) {
    if (!cell.is_wide || cell.level > largest_level + 1)
      continue;
    const bool cell_is_exact = isExact (cell, finest_cell);
    forLeavesIn (cell, leaves, [&] (std::size_t leaf) {
      if (leaves[leaf].level == cell.level)
        is_exact[leaf] = cell_is_exact ? 1 : 0;
      else if (leaves[leaf].level == cell.level - 1 && !cell_is_exact)
        is_on_step[leaf] = is_exact[leaf];
    });
  }
  return is_on_step;
}

} // namespace

double
shareOfCommonErrors (const CurvePoints& points,
                     const std::vector<CellScatter>& cells,
                     const ExpectedNoise& expected,
                     const std::vector<Leaf>& leaves)
{
  const std::vector<char> is_on_step = leavesOnSteps (cells, leaves, points.cell);
  double all = 0.0;
  double erring = 0.0;
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    const double number = leaves[i].end - leaves[i].begin;
    const double density = densityOf (number, leaves[i].level);
    all += number;
    if (is_on_step[i] != 0 ||
        (isUneven (leaves[i]) && expected.isNoise (density, leaves[i].level)))
      erring += number;
  }
  return all > 0.0 ? erring / all : 0.0;
}

} // namespace pcl_ops::internal
