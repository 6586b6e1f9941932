// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "plan_rooms.h"

#include "cell_lines.h"
#include "constants.h"
#include "covered_squares.h"
#include "inside_cells.h"
#include "plan_cells.h"
#include "planar_area.h"
#include "side_rings.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

namespace pcl_ops::internal::buildings {
namespace {

using Eigen::Vector2d;

/** \brief Union-find of cells: the cells of one room are one set. */
class CellSets {
public:
  explicit CellSets (std::size_t cells) : parents_ (cells)
  {
    std::iota (parents_.begin(), parents_.end(), std::size_t (0));
  }

  std::size_t
  rootOf (std::size_t cell)
  {
    while (parents_[cell] != cell) {
      parents_[cell] = parents_[parents_[cell]];
      cell = parents_[cell];
    }
    return cell;
  }

  void
  join (std::size_t first, std::size_t second)
  {
    const std::size_t one = rootOf (first);
    const std::size_t other = rootOf (second);
    parents_[std::max (one, other)] = std::min (one, other);
  }

private:
  std::vector<std::size_t> parents_;
};

/** \brief Returns the length of the parts of a side that are walls [m]. */
double
walledLength (const PlanSide& side, const std::vector<CellLine>& lines)
{
  if (side.line == no_line)
    return 0.0;
  const PlanLine& line = lines[side.line].line;
  const double from = line.positionOf (side.from);
  const double to = line.positionOf (side.to);
  return lengthWithin ({std::min (from, to), std::max (from, to)},
                       lines[side.line].walls);
}

PlanSide
sideOf (const PlanCell& cell, std::size_t i)
{
  return {cell.corners[i], cell.corners[(i + 1) % cell.corners.size()], cell.lines[i]};
}

/** \brief Returns the centroid of the area of a room; nothing if it is outside, as it
 * may be for an L. */
std::optional<Vector2d>
centerOf (const PlanarRings& rings)
{
  Vector2d sum = Vector2d::Zero();
  double twice_area = 0.0;
  const Vector2d& origin = rings.front().front();
  for (const PlanarPoints& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vector2d from = ring[i] - origin;
      const Vector2d to = ring[(i + 1) % ring.size()] - origin;
      twice_area += cross (from, to);
      sum += cross (from, to) * (from + to);
    }
  const Vector2d center = origin + sum / (3.0 * twice_area);
  for (const PlanarPoints& ring : rings)
    if (isWithinRing (ring, center) != (&ring == &rings.front()))
      return {};
  return center;
}

/** \brief Returns a room with outline, holes, area and a position inside; its area is 0
 * if the sides form no ring.
 * \param[in] largest the largest cell of the room */
PlanRoom
roomWithin (const std::vector<PlanSide>& sides, const PlanCell& largest)
{
  PlanarRings rings = ringsOf (sides);
  std::sort (rings.begin(), rings.end(), [] (const auto& a, const auto& b) {
    return areaOf (a) > areaOf (b);
  });
  PlanRoom room;
  for (PlanarPoints& ring : rings) {
    const double area = areaOf (ring); // below 0 for a hole
    if (!room.rings.empty() && area > -constants.min_hole_area)
      continue;
    room.area += area;
    room.rings.push_back (std::move (ring));
  }
  for (const Vector2d& corner : largest.corners)
    room.middle += corner / static_cast<double> (largest.corners.size());
  if (!room.rings.empty())
    room.middle = centerOf (room.rings).value_or (room.middle);
  return room;
}

double
medianOf (std::vector<double>& values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t> (values.size() / 2);
  std::nth_element (values.begin(), middle, values.end());
  return *middle;
}

/** \brief Returns the median over grid squares of the median height of the points in a
 * ring [m]; nothing without points. Each square counts once, because most points are
 * near the sensor and a scan that drifted is bent. The median of all points made the
 * height of a measured room wrong by 3.4 cm, that of squares by less than 1 cm. */
std::optional<double>
heightIn (const PlanarPoints& ring, const PlanPoints& points)
{
  Eigen::AlignedBox2d box;
  for (const Vector2d& corner : ring)
    box.extend (corner);
  std::map<std::pair<long, long>, std::vector<double>> squares;
  for (const Eigen::Vector3d& point : points)
    if (box.contains (point.head<2>().eval()) && isWithinRing (ring, point.head<2>())) {
      const Vector2d square =
          (point.head<2>() - box.min()) / constants.edge_of_height_square;
      squares[{std::lround (square.x()), std::lround (square.y())}].push_back (
          point.z());
    }
  if (squares.empty())
    return {};
  std::vector<double> heights;
  for (auto& [square, of_square] : squares)
    heights.push_back (medianOf (of_square));
  return medianOf (heights);
}

Eigen::AlignedBox2d
boxAround (const std::vector<WallFace>& faces, const std::vector<WallSpan>& spans)
{
  Eigen::AlignedBox2d box;
  for (const WallSpan& span : spans)
    for (const double end : {span.whole.from, span.whole.to})
      box.extend (faces[span.face].line.at (end));
  return {box.min().array() - constants.margin_of_plan,
          box.max().array() + constants.margin_of_plan};
}

std::vector<PlanCell>
cellsBetween (const std::vector<CellLine>& lines, const Eigen::AlignedBox2d& box)
{
  std::vector<PlanLine> all;
  for (const CellLine& line : lines)
    all.push_back (line.line);
  return cellsOf (box, all);
}

/** \brief Lines with their walls, and the cells into which the lines divide a plan. */
struct DividedPlan {
  std::vector<CellLine> lines;
  std::vector<PlanCell> cells;
  std::vector<char> is_inside; // of each cell
};

/** \brief Length of the border of a cell, and of its parts on walls and on the rim of
 * the plan [m]. */
struct BorderLengths {
  double length = 0.0;
  double walled = 0.0;
  double rim = 0.0;
  /** \brief The same without the side that has the greatest length of walls. */
  double other_length = 0.0;
  double other_walled = 0.0;
};

BorderLengths
borderLengthsOf (const PlanCell& cell, const DividedPlan& plan)
{
  BorderLengths outline;
  double most_walled = -1.0;
  double length_of_most = 0.0;
  for (std::size_t i = 0; i < cell.corners.size(); ++i) {
    const PlanSide side = sideOf (cell, i);
    const double length = side.length();
    const double walled = walledLength (side, plan.lines);
    outline.length += length;
    outline.walled += walled;
    outline.rim += side.line == no_line ? length : 0.0;
    if (walled > most_walled) {
      most_walled = walled;
      length_of_most = length;
    }
  }
  outline.other_length = outline.length - length_of_most;
  outline.other_walled = outline.walled - most_walled;
  return outline;
}

/** \brief Returns whether the width of an area of about the shape of a rectangle is
 * less than min_room_width. As the width counts 2 area / length of the border, which is
 * below the width of a rectangle and near it for a long one. */
bool
isNarrow (double area, double border)
{
  return 2.0 * area < constants.min_room_width * border;
}

/** \brief Returns the evidence for and against a cell being in a room. A narrow cell is
 * within a wall if walls are on most of its border even without its most walled side.
 * Then all its area and border count against it. */
CellEvidence
evidenceOfCell (const PlanCell& cell,
                const DividedPlan& plan,
                const CoveredSquares& squares)
{
  const double area = areaOf (cell.corners);
  const BorderLengths outline = borderLengthsOf (cell, plan);
  const bool has_walls_around =
      outline.other_walled > constants.min_walled * outline.other_length;
  if (isNarrow (area, outline.length) && has_walls_around)
    return {0.0, area, outline.length};
  const double share = squares.shareOf (cell);
  return {share * area, (1.0 - share) * area, outline.rim};
}

/** \brief Returns whether a cell is as narrow as walls are thick, and has exactly two
 * long sides, both on lines of walls with the cell behind them. */
bool
isWithinWall (const PlanCell& cell, const DividedPlan& plan)
{
  const double length = borderLengthsOf (cell, plan).length;
  const bool is_wide = 2.0 * areaOf (cell.corners) > constants.min_room_width * length;
  if (is_wide)
    return false;
  Vector2d middle = Vector2d::Zero();
  for (const Vector2d& corner : cell.corners)
    middle += corner / static_cast<double> (cell.corners.size());
  // Numbers of long sides with the cell behind them, and of others.
  std::size_t behind = 0;
  std::size_t before = 0;
  for (std::size_t i = 0; i < cell.corners.size(); ++i) {
    const PlanSide side = sideOf (cell, i);
    const bool is_short = 4.0 * side.length() < length; // below a quarter of the border
    if (is_short)
      continue;
    const bool is_behind = side.line != no_line &&
                           !plan.lines[side.line].walls.empty() &&
                           plan.lines[side.line].line.distance (middle) < 0.0;
    ++(is_behind ? behind : before);
  }
  return behind == 2 && before == 0;
}

/** \brief Returns for each cell whether it is in a room, by its cover and its walls. */
std::vector<char>
cellsInRooms (const DividedPlan& plan,
              const PlanPoints& cover,
              const Eigen::AlignedBox2d& box)
{
  const double edge = std::max (
      constants.min_edge_of_cover,
      std::sqrt (constants.points_of_cover_square / meanDensityOf (cover, box)));
  const CoveredSquares squares (cover, box, edge);
  std::vector<CellEvidence> evidence;
  for (const PlanCell& cell : plan.cells)
    evidence.push_back (evidenceOfCell (cell, plan, squares));
  std::vector<CellBorder> borders;
  for (const auto& [first, second, i] : commonSides (plan.cells)) {
    const PlanSide side = sideOf (plan.cells[first], i);
    const double walled = walledLength (side, plan.lines);
    borders.push_back ({first, second, std::max (0.0, side.length() - walled)});
  }
  return cellsInside (evidence, borders);
}

/** \brief Takes cells within walls out of rooms, so that no room goes through a wall
 * where neither side of the wall was seen, as at a door beside a missing piece. Floors
 * and ceilings end at such a part of a wall, too: the cell has few of their points. */
void
leaveOutCellsWithinWalls (const PlanPoints& cover,
                          const Eigen::AlignedBox2d& box,
                          DividedPlan& plan)
{
  const CoveredSquares squares (cover, box, constants.edge_of_side_square);
  const double max_density =
      constants.max_cover_within_wall * meanDensityOf (cover, box);
  for (std::size_t i = 0; i < plan.cells.size(); ++i)
    if (plan.is_inside[i] && isWithinWall (plan.cells[i], plan) &&
        squares.densityOf (plan.cells[i]) < max_density)
      plan.is_inside[i] = 0;
}

/** \brief Joins cells in rooms whose common side is mostly without a wall. */
CellSets
joinCells (const DividedPlan& plan)
{
  CellSets sets (plan.cells.size());
  for (const auto& [first, second, i] : commonSides (plan.cells)) {
    const PlanSide side = sideOf (plan.cells[first], i);
    const bool is_open =
        walledLength (side, plan.lines) < constants.min_walled * side.length();
    if (plan.is_inside[first] && plan.is_inside[second] && is_open)
      sets.join (first, second);
  }
  return sets;
}

/** \brief A side of a cell: the index of the cell, and that of the side in it. */
using CellSide = std::pair<std::size_t, std::size_t>;

/** \brief Maps sides of cells to the index of the cell beyond the side. */
std::map<CellSide, std::size_t>
cellsBeyondSides (const std::vector<PlanCell>& cells)
{
  constexpr double rounding = 1e-3; // [m]
  std::map<CellSide, std::size_t> neighbors;
  for (const auto& [first, second, i] : commonSides (cells)) {
    neighbors[{first, i}] = second;
    const PlanSide side = sideOf (cells[first], i);
    for (std::size_t j = 0; j < cells[second].corners.size(); ++j)
      if (const PlanSide other = sideOf (cells[second], j);
          (other.from - side.to).norm() < rounding &&
          (other.to - side.from).norm() < rounding)
        neighbors[{second, j}] = first;
  }
  return neighbors;
}

/** \brief The cells of a room: the index of the largest one, and the outline of all. */
struct JoinedCells {
  std::size_t largest;
  std::vector<PlanSide> outline; // sides with no other cell of the room beyond them
};

/** \brief Returns the cells of each room, by the root of their set. */
std::map<std::size_t, JoinedCells>
outlinesOf (const DividedPlan& plan, CellSets& sets)
{
  const std::vector<PlanCell>& cells = plan.cells;
  const auto neighbors = cellsBeyondSides (cells);
  std::map<std::size_t, JoinedCells> rooms;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (!plan.is_inside[c])
      continue;
    const std::size_t root = sets.rootOf (c);
    JoinedCells& room = rooms.emplace (root, JoinedCells{c, {}}).first->second;
    if (areaOf (cells[c].corners) > areaOf (cells[room.largest].corners))
      room.largest = c;
    for (std::size_t i = 0; i < cells[c].corners.size(); ++i) {
      const auto neighbor = neighbors.find ({c, i});
      if (neighbor == neighbors.end() || !plan.is_inside[neighbor->second] ||
          sets.rootOf (neighbor->second) != root)
        room.outline.push_back (sideOf (cells[c], i));
    }
  }
  return rooms;
}

/** \brief Returns the parts of a side that are no wall, by positions along another line
 * on which the side lies. */
Intervals
partsWithoutWall (const PlanSide& side, const PlanLine& along, const DividedPlan& plan)
{
  if (side.line == no_line)
    return {{along.positionOf (side.from), along.positionOf (side.to)}};
  const PlanLine& wall = plan.lines[side.line].line;
  const auto [from, to] =
      std::minmax ({wall.positionOf (side.from), wall.positionOf (side.to)});
  Intervals parts;
  for (const Interval& part : without ({{from, to}}, plan.lines[side.line].walls)) {
    const auto [first, second] = std::minmax (
        {along.positionOf (wall.at (part.from)), along.positionOf (wall.at (part.to))});
    parts.push_back ({first, second});
  }
  return parts;
}

/** \brief Returns the parts of rings that are no wall and not shorter than
 * min_unseen_part, by their two ends. */
std::vector<std::pair<Vector2d, Vector2d>>
partsWithoutWall (const PlanarRings& rings,
                  const std::vector<PlanSide>& outline,
                  const DividedPlan& plan)
{
  constexpr double rounding = 1e-3; // [m]
  std::vector<std::pair<Vector2d, Vector2d>> parts;
  for (const PlanarPoints& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vector2d edge = ring[(i + 1) % ring.size()] - ring[i];
      const PlanLine line{ring[i], edge.normalized()};
      const auto is_on_edge = [&] (const PlanSide& side) {
        return std::abs (line.distance (side.from)) < rounding &&
               std::abs (line.distance (side.to)) < rounding &&
               line.positionOf (side.from) > -rounding &&
               line.positionOf (side.to) < edge.norm() + rounding;
      };
      Intervals open;
      for (const PlanSide& side : outline)
        if (is_on_edge (side))
          open = unionOf (open, partsWithoutWall (side, line, plan), rounding);
      for (const Interval& part : open)
        if (part.length() >= constants.min_unseen_part)
          parts.emplace_back (line.at (part.from), line.at (part.to));
    }
  return parts;
}

/** \brief Returns the room of joined cells; without rings if it is smaller than
 * \p smallest_area [m^2] or too narrow, or too little of its outline is walls. */
PlanRoom
roomOf (const JoinedCells& joined, const DividedPlan& plan, double smallest_area)
{
  double length = 0.0;
  double walled = 0.0;
  for (const PlanSide& side : joined.outline) {
    length += side.length();
    walled += walledLength (side, plan.lines);
  }
  PlanRoom room = roomWithin (joined.outline, plan.cells[joined.largest]);
  if (room.area < smallest_area || isNarrow (room.area, length) ||
      walled < constants.min_walled * length)
    return {};
  room.enclosed = walled / length;
  room.unseen = partsWithoutWall (room.rings, joined.outline, plan);
  return room;
}

} // namespace

std::vector<PlanRoom>
roomsOf (const std::vector<WallFace>& faces,
         const std::vector<WallSpan>& spans,
         const Cover& cover,
         double smallest_area)
{
  if (spans.empty() || spans.size() > constants.max_walls)
    return {};
  DividedPlan plan{cellLinesOf (faces, spans), {}, {}};
  const Eigen::AlignedBox2d box = boxAround (faces, spans);
  plan.cells = cellsBetween (plan.lines, box);
  plan.is_inside = cellsInRooms (plan, cover.points, box);
  leaveOutCellsWithinWalls (cover.points, box, plan);
  CellSets sets = joinCells (plan);
  std::vector<PlanRoom> rooms;
  for (const auto& [root, joined] : outlinesOf (plan, sets)) {
    PlanRoom room = roomOf (joined, plan, smallest_area);
    if (room.rings.empty())
      continue;
    room.floor = heightIn (room.rings.front(), cover.floor);
    room.ceiling = heightIn (room.rings.front(), cover.ceiling);
    rooms.push_back (std::move (room));
  }
  std::stable_sort (rooms.begin(), rooms.end(), [] (const auto& a, const auto& b) {
    return a.area > b.area;
  });
  return rooms;
}

} // namespace pcl_ops::internal::buildings
