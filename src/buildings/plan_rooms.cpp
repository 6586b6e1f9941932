// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "plan_rooms.h"

#include "cell_lines.h"
#include "constants.h"
#include "covered_squares.h"
#include "inside_cells.h"
#include "plan_cells.h"
#include "planar_area.h"
#include "room_graph.h"
#include "side_rings.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

namespace pcl_ops::internal::buildings {
namespace {

using Eigen::Vector2d;

/** \brief Positions this near are the same but for rounding [m]. Chosen by hand. */
constexpr double rounding = 1e-3;

/** \brief Union-find of cells: the cells of one room are one set. */
class CellSets {
public:
  explicit CellSets (std::size_t cells) : parents_ (cells)
  {
    std::iota (parents_.begin(), parents_.end(), std::size_t (0));
  }

  /** \brief Returns the cell that represents the set of \p cell. */
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
    const std::size_t first_root = rootOf (first);
    const std::size_t second_root = rootOf (second);
    parents_[std::max (first_root, second_root)] = std::min (first_root, second_root);
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
  return coveredLength ({std::min (from, to), std::max (from, to)},
                        lines[side.line].walls);
}

/** \brief Returns the side of a cell from corner \p i to the next. */
PlanSide
sideOf (const PlanCell& cell, std::size_t i)
{
  return {cell.corners[i], cell.corners[(i + 1) % cell.corners.size()], cell.lines[i]};
}

/** \brief Returns the centroid of the area of a room; nothing if the centroid is
 * outside of the room, as it may be for a room of the shape of an L. */
std::optional<Vector2d>
centroidInside (const PlanarRings& rings)
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
  const Vector2d centroid = origin + sum / (3.0 * twice_area);
  for (const PlanarPoints& ring : rings) {
    const bool is_hole = &ring != &rings.front();
    if (isWithinRing (ring, centroid) == is_hole)
      return {};
  }
  return centroid;
}

/** \brief Returns a room with outline, holes, area and a position inside; its area is 0
 * if the sides form no ring.
 * \param[in] sides around the cells of the room, and around its holes
 * \param[in] largest_cell the largest cell of the room */
PlanRoom
roomWithin (const std::vector<PlanSide>& sides, const PlanCell& largest_cell)
{
  PlanarRings rings = ringsOf (sides);
  // The outline has the largest area; holes are clockwise, so that their areas are
  // negative.
  std::sort (rings.begin(), rings.end(), [] (const auto& a, const auto& b) {
    return areaOf (a) > areaOf (b);
  });
  PlanRoom room;
  for (PlanarPoints& ring : rings) {
    const double area = areaOf (ring);
    const bool is_outline = room.rings.empty();
    if (!is_outline && area > -constants.min_hole_area)
      continue;
    room.area += area;
    room.rings.push_back (std::move (ring));
  }
  for (const Vector2d& corner : largest_cell.corners)
    room.middle += corner / static_cast<double> (largest_cell.corners.size());
  if (!room.rings.empty())
    room.middle = centroidInside (room.rings).value_or (room.middle);
  return room;
}

/** \brief Returns the median, or the upper one of two middle values.
 * \param[in,out] values at least one; reordered */
double
medianOf (std::vector<double>& values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t> (values.size() / 2);
  std::nth_element (values.begin(), middle, values.end());
  return *middle;
}

Eigen::AlignedBox2d
boxAround (const PlanarPoints& points)
{
  Eigen::AlignedBox2d box;
  for (const Vector2d& point : points)
    box.extend (point);
  return box;
}

/** \brief Returns the height of the points in a room [m]: the median over grid squares
 * of the median height in the square; nothing without points. Each square counts once,
 * because most points are near the sensor, and floors and ceilings are bent where the
 * pose of the scan drifted. In a measured room the median of all points was wrong
 * by 3.4 cm, the median over squares by less than 1 cm. */
std::optional<double>
heightIn (const PlanRoom& room, const PlanPoints& points)
{
  const Eigen::AlignedBox2d box = boxAround (room.rings.front());
  std::map<std::pair<long, long>, std::vector<double>> squares; // heights by square
  for (const Eigen::Vector3d& point : points)
    if (box.contains (point.head<2>().eval()) && isInRoom (room, point.head<2>())) {
      const Vector2d square =
          (point.head<2>() - box.min()) / constants.edge_of_height_square;
      squares[{std::lround (square.x()), std::lround (square.y())}].push_back (
          point.z());
    }
  if (squares.empty())
    return {};
  std::vector<double> heights;
  for (auto& [square, heights_in_square] : squares)
    heights.push_back (medianOf (heights_in_square));
  return medianOf (heights);
}

/** \brief Returns the main direction of the walls, a unit vector: the mean of their
 * directions, weighted by length, where directions at right angles are the same. The
 * fourth power of a unit complex number has four times its angle, so that it is the
 * same after each quarter of a turn. */
Vector2d
mainDirectionOf (const std::vector<WallFace>& faces, const std::vector<WallSpan>& spans)
{
  std::complex<double> sum = 0.0;
  for (const WallSpan& span : spans) {
    const Vector2d& along = faces[span.face].line.along;
    const std::complex<double> direction (along.x(), along.y());
    const std::complex<double> square = direction * direction;
    sum += span.whole.length() * square * square;
  }
  const double angle = std::arg (sum) / 4.0;
  return {std::cos (angle), std::sin (angle)};
}

/** \brief Returns the corners of the rim of the plan, counter-clockwise: a rectangle
 * margin_of_plan beyond all walls. It lies along their main direction, so that it turns
 * with the building. */
PlanarPoints
rimAround (const std::vector<WallFace>& faces, const std::vector<WallSpan>& spans)
{
  const PlanLine axis{Vector2d::Zero(), mainDirectionOf (faces, spans)};
  Eigen::AlignedBox2d box; // of positions along the axis, and of distances to it
  for (const WallSpan& span : spans)
    for (const double position : {span.whole.from, span.whole.to}) {
      const Vector2d end = faces[span.face].line.at (position);
      box.extend (Vector2d (axis.positionOf (end), axis.distance (end)));
    }
  const Vector2d low = box.min().array() - constants.margin_of_plan;
  const Vector2d high = box.max().array() + constants.margin_of_plan;
  PlanarPoints rim;
  for (const Vector2d& corner :
       {low, Vector2d (high.x(), low.y()), high, Vector2d (low.x(), high.y())})
    rim.push_back (axis.at (corner.x()) + corner.y() * axis.normal());
  return rim;
}

std::vector<PlanCell>
cellsBetween (const std::vector<CellLine>& lines, const PlanarPoints& rim)
{
  std::vector<PlanLine> all;
  for (const CellLine& line : lines)
    all.push_back (line.line);
  return cellsOf (rim, all);
}

/** \brief Lines with their walls, and the cells into which the lines divide a plan. */
struct DividedPlan {
  std::vector<CellLine> lines;
  std::vector<PlanCell> cells;
  std::vector<char> is_inside; // of each cell
};

/** \brief Lengths of the border of a cell [m]. */
struct BorderLengths {
  double whole = 0.0;
  double walled = 0.0; // of the parts on walls
  double on_rim = 0.0; // of the parts on the rim of the plan
  /** \brief Whole and walled length without the most walled side: the side that has the
   * greatest length of walls. */
  double whole_of_others = 0.0;
  double walled_of_others = 0.0;
};

BorderLengths
borderLengthsOf (const PlanCell& cell, const DividedPlan& plan)
{
  BorderLengths border;
  double most_walled = -1.0;
  double length_of_most_walled = 0.0;
  for (std::size_t i = 0; i < cell.corners.size(); ++i) {
    const PlanSide side = sideOf (cell, i);
    const double length = side.length();
    const double walled = walledLength (side, plan.lines);
    border.whole += length;
    border.walled += walled;
    border.on_rim += side.line == no_line ? length : 0.0;
    if (walled > most_walled) {
      most_walled = walled;
      length_of_most_walled = length;
    }
  }
  border.whole_of_others = border.whole - length_of_most_walled;
  border.walled_of_others = border.walled - most_walled;
  return border;
}

/** \brief Returns whether the width of an area of about the shape of a rectangle is
 * less than min_room_width. Its width is taken as 2 area / (length of its border),
 * which is less than the width of a rectangle, and nearly equal to it for a long one.
 * \param[in] area [m^2]
 * \param[in] border_length [m] */
bool
isNarrow (double area, double border_length)
{
  return 2.0 * area < constants.min_room_width * border_length;
}

/** \brief Returns the evidence for and against a cell being in a room. A narrow cell is
 * within a wall if walls are on most of its border even without its most walled side.
 * Then its whole area and its whole border count against it. */
CellEvidence
evidenceOfCell (const PlanCell& cell,
                const DividedPlan& plan,
                const CoveredSquares& squares)
{
  const double area = areaOf (cell.corners);
  const BorderLengths border = borderLengthsOf (cell, plan);
  const bool has_walls_around =
      border.walled_of_others > constants.min_walled_share * border.whole_of_others;
  if (isNarrow (area, border.whole) && has_walls_around)
    return {0.0, area, border.whole};
  const double covered_share = squares.coveredShareOf (cell);
  return {covered_share * area, (1.0 - covered_share) * area, border.on_rim};
}

/** \brief Returns whether a side is at least a quarter of the border of its cell, as
 * the two longer sides of a rectangle are. */
bool
isLong (const PlanSide& side, double border_length)
{
  return 4.0 * side.length() >= border_length;
}

/** \brief Returns whether a side is on the line of walls that have a position behind
 * them. */
bool
hasBackOfWallAt (const Vector2d& position,
                 const PlanSide& side,
                 const DividedPlan& plan)
{
  if (side.line == no_line || plan.lines[side.line].walls.empty())
    return false;
  const CellLine& line = plan.lines[side.line];
  return line.faces_both_ways || line.line.distance (position) < 0.0;
}

/** \brief Returns whether a cell is as narrow as walls are thick, and has exactly two
 * long sides, both on lines of walls that have the cell behind them. A strip narrower
 * than any wall only lies between lines of walls elsewhere. */
bool
isWithinWall (const PlanCell& cell, const DividedPlan& plan)
{
  const double border_length = borderLengthsOf (cell, plan).whole;
  const bool is_wide =
      2.0 * areaOf (cell.corners) > constants.min_room_width * border_length;
  if (is_wide)
    return false;
  Vector2d middle = Vector2d::Zero();
  for (const Vector2d& corner : cell.corners)
    middle += corner / static_cast<double> (cell.corners.size());
  std::size_t backs_of_walls = 0; // long sides on walls with the cell behind them
  std::size_t other_long_sides = 0;
  double length_of_long_sides = 0.0; // of all together [m]
  for (std::size_t i = 0; i < cell.corners.size(); ++i) {
    const PlanSide side = sideOf (cell, i);
    if (!isLong (side, border_length))
      continue;
    length_of_long_sides += side.length();
    ++(hasBackOfWallAt (middle, side, plan) ? backs_of_walls : other_long_sides);
  }
  const bool is_thin =
      2.0 * areaOf (cell.corners) < constants.min_thickness * length_of_long_sides;
  return backs_of_walls == 2 && other_long_sides == 0 && !is_thin;
}

/** \brief Returns for each cell whether it is in a room, by its cover and its walls. */
std::vector<char>
cellsInRooms (const DividedPlan& plan, const CoveredSquares& squares)
{
  std::vector<CellEvidence> evidence;
  for (const PlanCell& cell : plan.cells)
    evidence.push_back (evidenceOfCell (cell, plan, squares));
  std::vector<CellBorder> borders;
  for (const auto& [first, second, side_of_first] : commonSides (plan.cells)) {
    const PlanSide side = sideOf (plan.cells[first], side_of_first);
    const double walled = walledLength (side, plan.lines);
    borders.push_back ({first, second, std::max (0.0, side.length() - walled)});
  }
  return cellsInside (evidence, borders);
}

/** \brief A side of a cell: the index of the cell, and the index of the side in the
 * cell. */
using CellSide = std::pair<std::size_t, std::size_t>;

/** \brief Maps sides of cells to the index of the cell beyond the side. */
std::map<CellSide, std::size_t>
cellsBeyondSides (const std::vector<PlanCell>& cells)
{
  std::map<CellSide, std::size_t> neighbors;
  for (const auto& [first, second, side_of_first] : commonSides (cells)) {
    neighbors[{first, side_of_first}] = second;
    const PlanSide side = sideOf (cells[first], side_of_first);
    // Both cells are counter-clockwise: the side of the second one runs backwards.
    for (std::size_t j = 0; j < cells[second].corners.size(); ++j)
      if (const PlanSide other = sideOf (cells[second], j);
          (other.from - side.to).norm() < rounding &&
          (other.to - side.from).norm() < rounding)
        neighbors[{second, j}] = first;
  }
  return neighbors;
}

/** \brief Returns the density of points in the covered part of the cells beyond the
 * long sides of a cell [1/m^2]: that of the densest cell; infinite if none is covered.
 */
double
densityBeside (std::size_t cell,
               const std::vector<PlanCell>& cells,
               const std::map<CellSide, std::size_t>& beyond_sides,
               const CoveredSquares& squares)
{
  double border_length = 0.0;
  for (std::size_t i = 0; i < cells[cell].corners.size(); ++i)
    border_length += sideOf (cells[cell], i).length();
  std::optional<double> densest;
  for (std::size_t i = 0; i < cells[cell].corners.size(); ++i) {
    const auto beyond = beyond_sides.find ({cell, i});
    if (!isLong (sideOf (cells[cell], i), border_length) ||
        beyond == beyond_sides.end())
      continue;
    const PlanCell& other = cells[beyond->second];
    const double covered_share = squares.coveredShareOf (other);
    if (covered_share > 0.0)
      densest =
          std::max (densest.value_or (0.0), squares.densityOf (other) / covered_share);
  }
  return densest.value_or (std::numeric_limits<double>::infinity());
}

/** \brief Takes cells within walls out of rooms, so that no room extends through a wall
 * where neither side of the wall was seen, as beside a door. Floors and ceilings end at
 * such a part of a wall, too: the cell has few of their points, compared with the rooms
 * beside it, which may have been scanned more sparsely than others.
 * \param[in] mean_density of the points in the plan [1/m^2]
 * \param[in] squares for the cover of rooms
 * \param[in] small_squares narrower than walls are thick */
void
leaveOutCellsWithinWalls (double mean_density,
                          const CoveredSquares& squares,
                          const CoveredSquares& small_squares,
                          DividedPlan& plan)
{
  const auto beyond_sides = cellsBeyondSides (plan.cells);
  for (std::size_t i = 0; i < plan.cells.size(); ++i) {
    if (!plan.is_inside[i] || !isWithinWall (plan.cells[i], plan))
      continue;
    const double density =
        std::min (mean_density, densityBeside (i, plan.cells, beyond_sides, squares));
    if (small_squares.densityOf (plan.cells[i]) <
        constants.max_density_share_within_wall * density)
      plan.is_inside[i] = 0;
  }
}

/** \brief Finds the cells that are in rooms. */
void
findCellsInRooms (const PlanPoints& cover,
                  const Eigen::AlignedBox2d& box,
                  DividedPlan& plan)
{
  const double mean_density = meanDensityOf (cover, box);
  const double edge =
      std::max (constants.min_edge_of_cover_square,
                std::sqrt (constants.points_of_cover_square / mean_density));
  const CoveredSquares squares (cover, box, edge);
  plan.is_inside = cellsInRooms (plan, squares);
  const CoveredSquares small_squares (cover, box, constants.edge_of_side_square);
  leaveOutCellsWithinWalls (mean_density, squares, small_squares, plan);
}

/** \brief Returns the sets of cells that form rooms: two cells inside are in one room
 * if their common side is mostly without a wall. */
CellSets
joinCells (const DividedPlan& plan)
{
  CellSets sets (plan.cells.size());
  for (const auto& [first, second, side_of_first] : commonSides (plan.cells)) {
    const PlanSide side = sideOf (plan.cells[first], side_of_first);
    const bool is_open =
        walledLength (side, plan.lines) < constants.min_walled_share * side.length();
    if (plan.is_inside[first] && plan.is_inside[second] && is_open)
      sets.join (first, second);
  }
  return sets;
}

/** \brief The cells of a room. */
struct JoinedCells {
  std::size_t largest;           // index of the largest cell
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

/** \brief Returns the parts of a side that are no wall, as intervals of \p edge, a line
 * on which the side lies. */
Intervals
unwalledParts (const PlanSide& side, const PlanLine& edge, const DividedPlan& plan)
{
  if (side.line == no_line)
    return {{edge.positionOf (side.from), edge.positionOf (side.to)}};
  const PlanLine& line = plan.lines[side.line].line;
  const auto [from, to] =
      std::minmax ({line.positionOf (side.from), line.positionOf (side.to)});
  Intervals parts;
  for (const Interval& part : without ({{from, to}}, plan.lines[side.line].walls)) {
    const auto [begin, end] = std::minmax (
        {edge.positionOf (line.at (part.from)), edge.positionOf (line.at (part.to))});
    parts.push_back ({begin, end});
  }
  return parts;
}

/** \brief Returns both ends of each part of the rings of a room that is no wall and not
 * shorter than min_unseen_part.
 * \param[in] outline sides of the cells of the room, of which the rings consist */
std::vector<std::pair<Vector2d, Vector2d>>
unseenParts (const PlanarRings& rings,
             const std::vector<PlanSide>& outline,
             const DividedPlan& plan)
{
  std::vector<std::pair<Vector2d, Vector2d>> parts;
  for (const PlanarPoints& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vector2d to_next = ring[(i + 1) % ring.size()] - ring[i];
      const PlanLine edge{ring[i], to_next.normalized()};
      const auto is_on_edge = [&] (const PlanSide& side) {
        return std::abs (edge.distance (side.from)) < rounding &&
               std::abs (edge.distance (side.to)) < rounding &&
               edge.positionOf (side.from) > -rounding &&
               edge.positionOf (side.to) < to_next.norm() + rounding;
      };
      Intervals unwalled;
      for (const PlanSide& side : outline)
        if (is_on_edge (side))
          unwalled = unionOf (unwalled, unwalledParts (side, edge, plan), rounding);
      for (const Interval& part : unwalled)
        if (part.length() >= constants.min_unseen_part)
          parts.emplace_back (edge.at (part.from), edge.at (part.to));
    }
  return parts;
}

/** \brief Returns the room of joined cells; a room without rings if the cells are
 * smaller than \p smallest_area [m^2] or too narrow, or too little of their outline is
 * walls. */
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
      walled < constants.min_walled_share * length)
    return {};
  room.enclosed = std::min (1.0, walled / length); // rounding may exceed 1
  room.unseen = unseenParts (room.rings, joined.outline, plan);
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
  const PlanarPoints rim = rimAround (faces, spans);
  plan.cells = cellsBetween (plan.lines, rim);
  findCellsInRooms (cover.points, boxAround (rim), plan);
  CellSets sets = joinCells (plan);
  std::vector<PlanRoom> rooms;
  for (const auto& [root, joined] : outlinesOf (plan, sets)) {
    PlanRoom room = roomOf (joined, plan, smallest_area);
    if (room.rings.empty())
      continue;
    room.floor = heightIn (room, cover.floor);
    room.ceiling = heightIn (room, cover.ceiling);
    rooms.push_back (std::move (room));
  }
  std::stable_sort (rooms.begin(), rooms.end(), [] (const auto& a, const auto& b) {
    return a.area > b.area;
  });
  return rooms;
}

} // namespace pcl_ops::internal::buildings
