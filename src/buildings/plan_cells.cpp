// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "plan_cells.h"

#include "planar_area.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace pcl_ops::internal::buildings {
namespace {

/** \brief Points within this distance of a line lie on it [m]: more than rounding moves
 * a point up to 10^6 m from zero. */
constexpr double on_line = 1e-7;

/** \brief Returns whether two points lie on different sides of a line, neither on it.
 * \param[in] first, second their signed distances to the line [m] */
bool
areOnDifferentSides (double first, double second)
{
  return (first > on_line && second < -on_line) ||
         (first < -on_line && second > on_line);
}

/** \brief Returns the part of a cell on one side of a line.
 * \param[in] sign 1 for the part in front of the line, -1 for the part behind it
 * \param[in] line_index index of \p line in the list of lines
 * \return a cell without corners if there is no part, or hardly any */
PlanCell
partOf (const PlanCell& cell, const PlanLine& line, double sign, std::size_t line_index)
{
  PlanCell part;
  const std::size_t corners = cell.corners.size();
  for (std::size_t i = 0; i < corners; ++i) {
    const Eigen::Vector2d& from = cell.corners[i];
    const Eigen::Vector2d& to = cell.corners[(i + 1) % corners];
    const double from_distance = sign * line.distance (from);
    const double to_distance = sign * line.distance (to);
    const bool is_from_in_part = from_distance >= -on_line;
    const bool is_to_in_part = to_distance >= -on_line;
    if (is_from_in_part) {
      part.corners.push_back (from);
      // If the cell leaves the part at a corner on the line, the next side of the part
      // runs along the line.
      const bool runs_along_line = !is_to_in_part && from_distance <= on_line;
      part.lines.push_back (runs_along_line ? line_index : cell.lines[i]);
    }
    if (areOnDifferentSides (from_distance, to_distance)) {
      part.corners.push_back (from + from_distance / (from_distance - to_distance) *
                                         (to - from));
      part.lines.push_back (is_from_in_part ? line_index : cell.lines[i]);
    }
  }
  constexpr double smallest_area = 1e-10; // [m^2], chosen by hand
  if (part.corners.size() < 3 || areaOf (part.corners) < smallest_area)
    return {};
  return part;
}

/** \brief Returns whether a cell has corners in front of a line and behind it. */
bool
divides (const PlanLine& line, const PlanCell& cell)
{
  bool is_before = false;
  bool is_behind = false;
  for (const Eigen::Vector2d& corner : cell.corners) {
    const double distance = line.distance (corner);
    is_before = is_before || distance > on_line;
    is_behind = is_behind || distance < -on_line;
  }
  return is_before && is_behind;
}

/** \brief A side of a cell with the key by which the same side of another cell is
 * found: its line and the rounded sum (x, y) of its ends. */
struct KeyedSide {
  std::size_t line;
  long long sum_x, sum_y; // in steps of 0.1 mm
  std::size_t cell, side; // index of the cell, and of the side in the cell
};

/** \brief Returns the sides of all cells that are not on the rim, sorted by key. */
std::vector<KeyedSide>
sidesByKey (const std::vector<PlanCell>& cells)
{
  constexpr double step = 1e-4; // of the rounded sums [m], chosen by hand
  std::vector<KeyedSide> sides;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const PlanCell& cell = cells[c];
    for (std::size_t i = 0; i < cell.corners.size(); ++i) {
      if (cell.lines[i] == no_line)
        continue;
      const Eigen::Vector2d sum =
          cell.corners[i] + cell.corners[(i + 1) % cell.corners.size()];
      sides.push_back ({cell.lines[i],
                        std::llround (sum.x() / step),
                        std::llround (sum.y() / step),
                        c,
                        i});
    }
  }
  std::sort (sides.begin(), sides.end(), [] (const KeyedSide& a, const KeyedSide& b) {
    return std::tie (a.line, a.sum_x, a.sum_y, a.cell) <
           std::tie (b.line, b.sum_x, b.sum_y, b.cell);
  });
  return sides;
}

} // namespace

std::vector<PlanCell>
cellsOf (const PlanarPoints& rim, const std::vector<PlanLine>& lines)
{
  std::vector<PlanCell> cells = {{rim, std::vector<std::size_t> (rim.size(), no_line)}};
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::vector<PlanCell> divided;
    for (const PlanCell& cell : cells) {
      if (!divides (lines[i], cell)) {
        divided.push_back (cell);
        continue;
      }
      for (const double sign : {1.0, -1.0})
        if (PlanCell part = partOf (cell, lines[i], sign, i); !part.corners.empty())
          divided.push_back (std::move (part));
    }
    cells = std::move (divided);
  }
  return cells;
}

std::vector<CommonSide>
commonSides (const std::vector<PlanCell>& cells)
{
  const std::vector<KeyedSide> sides = sidesByKey (cells);
  // Rounding may separate the two sums of a common side by one step in x and in y.
  // Sorted sides from j on can equal side i only while this is true.
  const auto may_equal_x = [&] (std::size_t i, std::size_t j) {
    return sides[j].line == sides[i].line && sides[j].sum_x - sides[i].sum_x <= 1;
  };
  std::vector<CommonSide> common;
  std::vector<char> is_taken (sides.size(), 0);
  for (std::size_t i = 0; i < sides.size(); ++i)
    for (std::size_t j = i + 1; !is_taken[i] && j < sides.size() && may_equal_x (i, j);
         ++j)
      if (!is_taken[j] && std::llabs (sides[j].sum_y - sides[i].sum_y) <= 1 &&
          sides[j].cell != sides[i].cell) {
        is_taken[i] = is_taken[j] = 1;
        common.push_back ({sides[i].cell, sides[j].cell, sides[i].side});
      }
  return common;
}

} // namespace pcl_ops::internal::buildings
