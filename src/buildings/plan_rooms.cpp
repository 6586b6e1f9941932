// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "plan_rooms.h"

#include "constants.h"
#include "inside_cells.h"
#include "plan_cells.h"
#include "planar_area.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

namespace pcl_ops::internal::buildings {
namespace {

using Eigen::Vector2d;

/** \brief Returns the mean number of points in the box per square meter with points
 * [1/m^2]; infinite without points. */
double
densityOf (const PlanPoints& points, const Eigen::AlignedBox2d& box)
{
  double inside = 0.0;
  std::set<std::pair<long, long>> meters;
  for (const Eigen::Vector3d& point : points)
    if (box.contains (point.head<2>().eval())) {
      inside += 1.0;
      meters.emplace (std::lround (point.x()), std::lround (point.y()));
    }
  if (meters.empty())
    return std::numeric_limits<double>::infinity();
  return inside / static_cast<double> (meters.size());
}

/** \brief Numbers of points in the squares of a horizontal grid. */
class CoveredSquares {
public:
  /** \param[in] edge of a square [m]; enlarged if there would be too many squares */
  CoveredSquares (const PlanPoints& points, const Eigen::AlignedBox2d& box, double edge)
  {
    const Vector2d sizes = box.sizes();
    edge_ = std::max (edge,
                      std::sqrt (sizes.x() * sizes.y() / constants.max_cover_squares));
    low_ = box.min();
    columns_ = static_cast<std::size_t> (sizes.x() / edge_) + 1;
    rows_ = static_cast<std::size_t> (sizes.y() / edge_) + 1;
    points_.assign (columns_ * rows_, 0);
    for (const Eigen::Vector3d& point : points)
      if (box.contains (point.head<2>().eval()))
        ++points_[squareAt (point.head<2>())];
  }

  /** \brief Returns the share of a convex cell whose squares have points, 0 to 1. */
  double
  shareOf (const PlanCell& cell) const
  {
    return meanOf (cell, [] (std::uint32_t points) { return points > 0 ? 1.0 : 0.0; });
  }

  /** \brief Returns the density of points in a convex cell [1/m^2]. */
  double
  densityOf (const PlanCell& cell) const
  {
    return meanOf (cell, [this] (std::uint32_t points) {
      return static_cast<double> (points) / (edge_ * edge_);
    });
  }

private:
  template <typename Value>
  double
  meanOf (const PlanCell& cell, const Value& valueOf) const
  {
    Eigen::AlignedBox2d box;
    Vector2d middle = Vector2d::Zero();
    for (const Vector2d& corner : cell.corners) {
      box.extend (corner);
      middle += corner / static_cast<double> (cell.corners.size());
    }
    // Samples on a grid; in a sliver that contains no sample, only its middle.
    constexpr int max_samples = constants.max_samples_of_cell;
    const Vector2d wanted = (box.sizes() / edge_).array().ceil();
    const int columns = std::clamp (static_cast<int> (wanted.x()), 1, max_samples);
    const int rows = std::clamp (static_cast<int> (wanted.y()), 1, max_samples);
    int all = 0;
    double sum = 0.0;
    const auto ask = [&] (const Vector2d& place) {
      ++all;
      sum += valueOf (points_[squareAt (place)]);
    };
    for (int i = 0; i < columns; ++i)
      for (int j = 0; j < rows; ++j) {
        const Vector2d place =
            box.min() + Vector2d ((i + 0.5) / columns * box.sizes().x(),
                                  (j + 0.5) / rows * box.sizes().y());
        if (isWithin (cell, place))
          ask (place);
      }
    if (all == 0)
      ask (middle);
    return sum / all;
  }

  static bool
  isWithin (const PlanCell& cell, const Vector2d& place)
  {
    const std::size_t corners = cell.corners.size();
    for (std::size_t i = 0; i < corners; ++i) {
      const Vector2d& from = cell.corners[i];
      if (cross (cell.corners[(i + 1) % corners] - from, place - from) < 0.0)
        return false;
    }
    return true;
  }

  std::size_t
  squareAt (const Vector2d& place) const
  {
    const Vector2d square = ((place - low_) / edge_).array().max (0.0);
    return std::min (columns_ - 1, static_cast<std::size_t> (square.x())) * rows_ +
           std::min (rows_ - 1, static_cast<std::size_t> (square.y()));
  }

  double edge_;
  Vector2d low_;
  std::size_t columns_, rows_;
  std::vector<std::uint32_t> points_;
};

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

/** \brief A line that bounds cells, and the intervals of walls on it. */
struct CellLine {
  PlanLine line;
  Intervals walls = {};
};

/** \brief Returns whether a wall on another line passes through a place, or ends less
 * than margin_of_plan from it. */
bool
hasWallAt (const CellLine& other, const Vector2d& place)
{
  constexpr double on_line = 0.01; // [m]
  const double along = other.line.place (place);
  return std::abs (other.line.distance (place)) < on_line &&
         std::any_of (
             other.walls.begin(), other.walls.end(), [&] (const Interval& wall) {
               return along > wall.from - constants.margin_of_plan &&
                      along < wall.to + constants.margin_of_plan;
             });
}

/** \brief Returns how far the farthest wall reaches beyond a place in a direction [m];
 * 0 if no wall does. */
double
farthestBeyond (const std::vector<CellLine>& lines,
                const Vector2d& place,
                const Vector2d& direction)
{
  double farthest = 0.0;
  for (const CellLine& line : lines)
    for (const Interval& wall : line.walls)
      for (const double end : {wall.from, wall.to})
        farthest = std::max (farthest, direction.dot (line.line.at (end) - place));
  return farthest;
}

/** \brief Returns lines perpendicular to walls, at outermost ends that meet no other
 * wall. A room whose outer wall was not seen ends there and not at the rim of the plan.
 * Lines at all free ends (Mura et al. 2014) cut off parts of real rooms: of one of
 * 49 m^2, 30 m^2 were left. */
std::vector<CellLine>
linesAcrossFreeEnds (const std::vector<CellLine>& lines)
{
  std::vector<CellLine> across;
  for (std::size_t i = 0; i < lines.size(); ++i)
    for (const Interval& wall : lines[i].walls)
      for (const double at : {wall.from, wall.to}) {
        const Vector2d end = lines[i].line.at (at);
        const double outwards = at == wall.from ? -1.0 : 1.0;
        bool is_free = farthestBeyond (lines, end, outwards * lines[i].line.along) <
                       constants.max_off_line;
        for (std::size_t j = 0; j < lines.size(); ++j)
          is_free = is_free && (i == j || !hasWallAt (lines[j], end));
        // Both sides of a wall end at one place and share one line.
        for (const CellLine& other : across)
          is_free = is_free &&
                    (std::abs (other.line.distance (end)) > constants.max_off_line ||
                     std::abs (other.line.along.dot (lines[i].line.along)) >
                         constants.min_sine_of_meeting);
        if (is_free)
          across.push_back ({{end, lines[i].line.normal()}});
      }
  return across;
}

/** \brief Returns the lines that divide a plan: lines of walls, then lines across free
 * ends. The latter are left out if there would be more than max_walls lines. */
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
      lines.push_back (std::move (line));
  }
  const std::vector<CellLine> across = linesAcrossFreeEnds (lines);
  if (lines.size() + across.size() > constants.max_walls)
    return lines;
  lines.insert (lines.end(), across.begin(), across.end());
  return lines;
}

struct Side {
  Vector2d from, to;
  std::size_t line;
};

/** \brief Returns the length of the parts of a side that are walls [m]. */
double
walledLength (const Side& side, const std::vector<CellLine>& lines)
{
  if (side.line == no_line)
    return 0.0;
  const PlanLine& line = lines[side.line].line;
  const double from = line.place (side.from);
  const double to = line.place (side.to);
  return lengthWithin ({std::min (from, to), std::max (from, to)},
                       lines[side.line].walls);
}

Side
sideOf (const PlanCell& cell, std::size_t i)
{
  return {cell.corners[i], cell.corners[(i + 1) % cell.corners.size()], cell.lines[i]};
}

/** \brief Returns a ring without the corners at which it does not turn. */
PlanarPoints
withoutStraightCorners (const PlanarPoints& ring)
{
  constexpr double straight = 1e-5; // sine of the turn
  PlanarPoints corners;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vector2d before = ring[i] - ring[(i + ring.size() - 1) % ring.size()];
    const Vector2d after = ring[(i + 1) % ring.size()] - ring[i];
    if (std::abs (cross (before, after)) > straight * before.norm() * after.norm())
      corners.push_back (ring[i]);
  }
  return corners;
}

/** \brief Finds sides by their first corner; each side can be taken once. */
class SidesByBegin {
public:
  explicit SidesByBegin (const std::vector<Side>& sides) : is_used_ (sides.size(), 0)
  {
    for (std::size_t i = 0; i < sides.size(); ++i)
      by_begin_.emplace (placeOf (sides[i].from), i);
  }

  bool
  take (std::size_t side)
  {
    if (is_used_[side] != 0)
      return false;
    is_used_[side] = 1;
    return true;
  }

  /** \brief Returns a side that begins at \p end and was not taken; nothing if there is
   * none. */
  std::optional<std::size_t>
  nextOf (const Vector2d& end) const
  {
    // Coordinates may be rounded apart by one step.
    const auto [x, y] = placeOf (end);
    for (long long dx = -1; dx <= 1; ++dx)
      for (long long dy = -1; dy <= 1; ++dy)
        if (const auto side = leftAt ({x + dx, y + dy}))
          return side;
    return {};
  }

private:
  using Place = std::pair<long long, long long>;

  static Place
  placeOf (const Vector2d& point)
  {
    constexpr double step = 1e-4; // [m]
    return {std::llround (point.x() / step), std::llround (point.y() / step)};
  }

  std::optional<std::size_t>
  leftAt (const Place& place) const
  {
    const auto [first, last] = by_begin_.equal_range (place);
    for (auto found = first; found != last; ++found)
      if (is_used_[found->second] == 0)
        return found->second;
    return {};
  }

  std::multimap<Place, std::size_t> by_begin_;
  std::vector<char> is_used_;
};

/** \brief Joins sides end to end; rings with fewer than 3 corners are left out. */
PlanarRings
ringsOf (const std::vector<Side>& sides)
{
  SidesByBegin left (sides);
  PlanarRings rings;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    PlanarPoints ring;
    for (std::optional<std::size_t> side = i; side && left.take (*side);
         side = left.nextOf (sides[*side].to))
      ring.push_back (sides[*side].from);
    if (PlanarPoints corners = withoutStraightCorners (ring); corners.size() >= 3)
      rings.push_back (std::move (corners));
  }
  return rings;
}

/** \brief Returns the centroid of the area of a room; nothing if it is not inside. */
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

/** \brief Returns a room with outline, holes, area and a place inside; its area is 0 if
 * the sides form no ring.
 * \param[in] largest the largest cell of the room */
PlanRoom
roomWithin (const std::vector<Side>& sides, const PlanCell& largest)
{
  PlanarRings rings = ringsOf (sides);
  std::sort (rings.begin(), rings.end(), [] (const auto& a, const auto& b) {
    return areaOf (a) > areaOf (b);
  });
  PlanRoom room;
  for (PlanarPoints& ring : rings) {
    const double area = areaOf (ring);
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
 * near the sensor and a scan that drifted is bent. By the median of all points the
 * height of a measured room was wrong by 3.4 cm, by that of squares by less than 1 cm.
 */
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
struct CellOutline {
  double length = 0.0;
  double walled = 0.0;
  double rim = 0.0;
  /** \brief The same without the side that has the greatest length of walls. */
  double other_length = 0.0;
  double other_walled = 0.0;
};

CellOutline
borderOfCell (const PlanCell& cell, const DividedPlan& plan)
{
  CellOutline outline;
  double most_walled = -1.0;
  double length_of_most = 0.0;
  for (std::size_t i = 0; i < cell.corners.size(); ++i) {
    const Side side = sideOf (cell, i);
    const double length = (side.to - side.from).norm();
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

/** \brief Returns the evidence for and against a cell being in a room. A narrow cell
 * with walls on both sides is within a wall: all its area and border count against it.
 */
CellEvidence
evidenceOfCell (const PlanCell& cell,
                const DividedPlan& plan,
                const CoveredSquares& squares)
{
  const double area = areaOf (cell.corners);
  const CellOutline outline = borderOfCell (cell, plan);
  const bool is_narrow = 2.0 * area < constants.min_room_width * outline.length;
  if (is_narrow && outline.other_walled > constants.min_walled * outline.other_length)
    return {0.0, area, outline.length};
  const double share = squares.shareOf (cell);
  return {share * area, (1.0 - share) * area, outline.rim};
}

/** \brief Returns whether a cell is as narrow as walls are thick, has two long sides on
 * lines of walls, and lies behind both lines. */
bool
isWithinWall (const PlanCell& cell, const DividedPlan& plan)
{
  const double length = borderOfCell (cell, plan).length;
  if (2.0 * areaOf (cell.corners) > constants.min_room_width * length)
    return false;
  Vector2d middle = Vector2d::Zero();
  for (const Vector2d& corner : cell.corners)
    middle += corner / static_cast<double> (cell.corners.size());
  std::size_t behind = 0;
  std::size_t before = 0;
  for (std::size_t i = 0; i < cell.corners.size(); ++i) {
    const Side side = sideOf (cell, i);
    if (4.0 * (side.to - side.from).norm() < length)
      continue; // a short end of the cell
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
  const CoveredSquares squares (
      cover,
      box,
      std::max (constants.min_edge_of_cover,
                std::sqrt (constants.points_of_cover_square / densityOf (cover, box))));
  std::vector<CellEvidence> evidence;
  for (const PlanCell& cell : plan.cells)
    evidence.push_back (evidenceOfCell (cell, plan, squares));
  std::vector<CellBorder> borders;
  for (const auto& [first, second, i] : commonSides (plan.cells)) {
    const Side side = sideOf (plan.cells[first], i);
    const double walled = walledLength (side, plan.lines);
    borders.push_back (
        {first, second, std::max (0.0, (side.to - side.from).norm() - walled)});
  }
  return cellsInside (evidence, borders);
}

/** \brief Takes cells within walls out of rooms, so that no room goes through a wall
 * where neither side of the wall was seen, as at a door beside a missing piece. Floors
 * and ceilings end there all the same: such a cell has few points of the cover. */
void
leaveOutCellsWithinWalls (const PlanPoints& cover,
                          const Eigen::AlignedBox2d& box,
                          DividedPlan& plan)
{
  const CoveredSquares squares (cover, box, constants.edge_of_side_square);
  const double most = constants.max_cover_within_wall * densityOf (cover, box);
  for (std::size_t i = 0; i < plan.cells.size(); ++i)
    if (plan.is_inside[i] && isWithinWall (plan.cells[i], plan) &&
        squares.densityOf (plan.cells[i]) < most)
      plan.is_inside[i] = 0;
}

/** \brief Joins cells in rooms whose common side is mostly without a wall. */
CellSets
joinCells (const DividedPlan& plan)
{
  CellSets sets (plan.cells.size());
  for (const auto& [first, second, i] : commonSides (plan.cells)) {
    const Side side = sideOf (plan.cells[first], i);
    const double length = (side.to - side.from).norm();
    if (plan.is_inside[first] && plan.is_inside[second] &&
        walledLength (side, plan.lines) < constants.min_walled * length)
      sets.join (first, second);
  }
  return sets;
}

/** \brief Maps (cell, side of it) to the cell beyond the side, all by index. */
std::map<std::pair<std::size_t, std::size_t>, std::size_t>
cellsBeyondSides (const std::vector<PlanCell>& cells)
{
  constexpr double rounding = 1e-3; // [m]
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> neighbors;
  for (const auto& [first, second, i] : commonSides (cells)) {
    neighbors[{first, i}] = second;
    const Side side = sideOf (cells[first], i);
    for (std::size_t j = 0; j < cells[second].corners.size(); ++j)
      if (const Side other = sideOf (cells[second], j);
          (other.from - side.to).norm() < rounding &&
          (other.to - side.from).norm() < rounding)
        neighbors[{second, j}] = first;
  }
  return neighbors;
}

/** \brief The largest cell of a room, by index, and the outline of all its cells. */
struct JoinedCells {
  std::size_t largest;
  std::vector<Side> outline; // sides with no other cell of the room beyond them
};

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

/** \brief Returns the parts of a side that are no wall, by places along another line on
 * which the side lies. */
Intervals
partsWithoutWall (const Side& side, const PlanLine& along, const DividedPlan& plan)
{
  if (side.line == no_line)
    return {{along.place (side.from), along.place (side.to)}};
  const PlanLine& wall = plan.lines[side.line].line;
  const auto [from, to] = std::minmax ({wall.place (side.from), wall.place (side.to)});
  Intervals parts;
  for (const Interval& part : without ({{from, to}}, plan.lines[side.line].walls)) {
    const auto [first, second] = std::minmax (
        {along.place (wall.at (part.from)), along.place (wall.at (part.to))});
    parts.push_back ({first, second});
  }
  return parts;
}

/** \brief Returns the parts of rings that are no wall and not shorter than
 * min_unseen_part, two ends each. */
std::vector<std::pair<Vector2d, Vector2d>>
partsWithoutWall (const PlanarRings& rings,
                  const std::vector<Side>& outline,
                  const DividedPlan& plan)
{
  constexpr double rounding = 1e-3; // [m]
  std::vector<std::pair<Vector2d, Vector2d>> parts;
  for (const PlanarPoints& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vector2d way = ring[(i + 1) % ring.size()] - ring[i];
      const PlanLine edge{ring[i], way.normalized()};
      Intervals open;
      for (const Side& side : outline)
        if (std::abs (edge.distance (side.from)) < rounding &&
            std::abs (edge.distance (side.to)) < rounding &&
            edge.place (side.from) > -rounding &&
            edge.place (side.to) < way.norm() + rounding)
          open = unionOf (open, partsWithoutWall (side, edge, plan), rounding);
      for (const Interval& part : open)
        if (part.length() >= constants.min_unseen_part)
          parts.emplace_back (edge.at (part.from), edge.at (part.to));
    }
  return parts;
}

/** \brief Returns the room of joined cells; without rings if it is smaller than
 * \p smallest [m^2] or too narrow, or too little of its outline is walls. */
PlanRoom
roomOf (const JoinedCells& joined, const DividedPlan& plan, double smallest)
{
  double length = 0.0;
  double walled = 0.0;
  for (const Side& side : joined.outline) {
    length += (side.to - side.from).norm();
    walled += walledLength (side, plan.lines);
  }
  PlanRoom room = roomWithin (joined.outline, plan.cells[joined.largest]);
  const bool is_narrow = 2.0 * room.area < constants.min_room_width * length;
  if (room.area < smallest || is_narrow || walled < constants.min_walled * length)
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
         double smallest)
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
    PlanRoom room = roomOf (joined, plan, smallest);
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
