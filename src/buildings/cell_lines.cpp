// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cell_lines.h"

#include "constants.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl_ops::internal::buildings {
namespace {

using Eigen::Vector2d;

/** \brief Returns whether a wall on another line passes through a position, or ends
 * less than margin_of_plan from it. */
bool
hasWallAt (const CellLine& other, const Vector2d& position)
{
  // [m]; ends that were moved to the line are on it but for rounding. Chosen by hand.
  constexpr double on_line = 0.01;
  const double on_other = other.line.positionOf (position);
  return std::abs (other.line.distance (position)) < on_line &&
         std::any_of (
             other.walls.begin(), other.walls.end(), [&] (const Interval& wall) {
               return on_other > wall.from - constants.margin_of_plan &&
                      on_other < wall.to + constants.margin_of_plan;
             });
}

/** \brief Returns how far the farthest wall reaches beyond a position in a direction
 * [m]; 0 if no wall does. */
double
farthestBeyond (const std::vector<CellLine>& lines,
                const Vector2d& position,
                const Vector2d& direction)
{
  double farthest = 0.0;
  for (const CellLine& line : lines)
    for (const Interval& wall : line.walls)
      for (const double end : {wall.from, wall.to})
        farthest = std::max (farthest, direction.dot (line.line.at (end) - position));
  return farthest;
}

/** \brief Returns whether an end of a wall is free: no wall reaches farther outwards,
 * and no wall on another line meets the end.
 * \param[in] line_of_wall index of the wall's line in \p lines
 * \param[in] outwards unit vector along the wall, from the wall to its end */
bool
isFreeEnd (const std::vector<CellLine>& lines,
           std::size_t line_of_wall,
           const Vector2d& end,
           const Vector2d& outwards)
{
  if (!(farthestBeyond (lines, end, outwards) < constants.max_off_line))
    return false;
  for (std::size_t j = 0; j < lines.size(); ++j)
    if (j != line_of_wall && hasWallAt (lines[j], end))
      return false;
  return true;
}

/** \brief Returns lines perpendicular to walls, at their free ends. A room whose outer
 * wall was not seen ends there and not at the rim of the plan. Lines also at ends that
 * are not outermost (Mura et al. 2014) would cut off parts of real rooms: only 30 m^2
 * remained of a room of 49 m^2. */
std::vector<CellLine>
linesAcrossFreeEnds (const std::vector<CellLine>& lines)
{
  std::vector<CellLine> across;
  for (std::size_t i = 0; i < lines.size(); ++i)
    for (const Interval& wall : lines[i].walls)
      for (const double position : {wall.from, wall.to}) {
        const Vector2d end = lines[i].line.at (position);
        const double sign = position == wall.from ? -1.0 : 1.0;
        const Vector2d outwards = sign * lines[i].line.along;
        // Both sides of a wall end at one position and share one line across.
        const auto is_line_across = [&] (const CellLine& other) {
          return std::abs (other.line.distance (end)) <= constants.max_off_line &&
                 std::abs (other.line.along.dot (lines[i].line.along)) <=
                     constants.min_sine_of_meeting;
        };
        if (isFreeEnd (lines, i, end, outwards) &&
            std::none_of (across.begin(), across.end(), is_line_across))
          across.push_back ({{end, lines[i].line.normal()}});
      }
  return across;
}

/** \brief Returns whether all walls of another line are on \p line, too, whichever way
 * both lines run. */
bool
hasWallsOf (const CellLine& other, const PlanLine& line)
{
  // [m]: more than rounding makes of equal lines, far less than noise. Chosen by hand.
  constexpr double on_line = 1e-6;
  return std::all_of (
      other.walls.begin(), other.walls.end(), [&] (const Interval& wall) {
        return std::abs (line.distance (other.line.at (wall.from))) < on_line &&
               std::abs (line.distance (other.line.at (wall.to))) < on_line;
      });
}

/** \brief Adds a line with walls, or its walls to an equal line. Of two equal lines
 * only the first one would have sides of cells. */
void
addLine (CellLine added, std::vector<CellLine>& lines)
{
  const auto same =
      std::find_if (lines.begin(), lines.end(), [&added] (const CellLine& line) {
        return hasWallsOf (added, line.line) && hasWallsOf (line, added.line);
      });
  if (same == lines.end())
    return lines.push_back (std::move (added));
  same->faces_both_ways =
      same->faces_both_ways || same->line.along.dot (added.line.along) < 0.0;
  for (const Interval& wall : added.walls) {
    const auto [from, to] =
        std::minmax ({same->line.positionOf (added.line.at (wall.from)),
                      same->line.positionOf (added.line.at (wall.to))});
    same->walls = unionOf (same->walls, {{from, to}}, 0.0);
  }
}

} // namespace

std::vector<CellLine>
cellLinesOf (const std::vector<WallFace>& faces, const std::vector<WallSpan>& spans)
{
  std::vector<CellLine> lines;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    CellLine line{faces[i].line};
    for (const WallSpan& span : spans)
      if (span.face == i)
        line.walls.push_back (span.whole);
    if (!line.walls.empty())
      addLine (std::move (line), lines);
  }
  const std::vector<CellLine> across = linesAcrossFreeEnds (lines);
  if (lines.size() + across.size() > constants.max_walls)
    return lines;
  lines.insert (lines.end(), across.begin(), across.end());
  return lines;
}

} // namespace pcl_ops::internal::buildings
