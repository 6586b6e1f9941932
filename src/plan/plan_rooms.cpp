// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "plan/plan_rooms.h"

#include "geometry/planar_area.h"
#include "plan/plan_cells.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

namespace pcl_ops::internal {
namespace {

using Eigen::Vector2d;

/** \brief Which squares of a grid have points. */
class CoveredSquares {
public:
  CoveredSquares (const PlanPoints& points, const Eigen::AlignedBox2d& box)
  {
    constexpr double smallest = 0.1, most_squares = 4e6; // [m]
    const Vector2d sizes = box.sizes();
    edge_ = std::max (smallest, std::sqrt (sizes.x() * sizes.y() / most_squares));
    low_ = box.min();
    columns_ = static_cast<std::size_t> (sizes.x() / edge_) + 1;
    rows_ = static_cast<std::size_t> (sizes.y() / edge_) + 1;
    has_points_.assign (columns_ * rows_, 0);
    for (const Eigen::Vector3d& point : points)
      if (box.contains (point.head<2>().eval()))
        has_points_[squareAt (point.head<2>())] = 1;
  }

  /** \brief How much of a convex cell has points, 0 to 1. */
  double
  shareOf (const PlanCell& cell) const
  {
    Eigen::AlignedBox2d box;
    Vector2d middle = Vector2d::Zero();
    for (const Vector2d& corner : cell.corners) {
      box.extend (corner);
      middle += corner / static_cast<double> (cell.corners.size());
    }
    // Samples in proportion to the cell, so that slivers have some, too.
    constexpr int fewest = 3, most = 60;
    const Vector2d wanted = (box.sizes() / edge_).array().ceil();
    const int columns = std::clamp (static_cast<int> (wanted.x()), fewest, most);
    const int rows = std::clamp (static_cast<int> (wanted.y()), fewest, most);
    int all = 0, covered = 0;
    const auto ask = [&] (const Vector2d& place) {
      ++all;
      covered += has_points_[squareAt (place)];
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
    return static_cast<double> (covered) / all;
  }

private:
  static bool
  isWithin (const PlanCell& cell, const Vector2d& place)
  {
    const std::size_t corners = cell.corners.size();
    for (std::size_t i = 0; i < corners; ++i)
      if (twiceTheArea (cell.corners[i], cell.corners[(i + 1) % corners], place) < 0.0)
        return false;
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
  std::vector<char> has_points_;
};

/** \brief The cells of each room: sets that no wall divides. */
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
    const std::size_t one = rootOf (first), other = rootOf (second);
    parents_[std::max (one, other)] = std::min (one, other);
  }

private:
  std::vector<std::size_t> parents_;
};

/** \brief Where each line has walls. */
std::vector<Intervals>
wallsOnLines (std::size_t lines, const std::vector<WallSpan>& spans)
{
  std::vector<Intervals> walls (lines);
  for (const WallSpan& span : spans)
    walls[span.face].push_back (span.whole);
  return walls;
}

struct Side {
  Vector2d from, to;
  std::size_t line;
};

/** \brief How much of a side is a wall [m]. */
double
walledLength (const Side& side,
              const std::vector<WallFace>& faces,
              const std::vector<Intervals>& walls)
{
  if (side.line == no_line)
    return 0.0;
  const PlanLine& line = faces[side.line].line;
  const double from = line.place (side.from), to = line.place (side.to);
  return lengthWithin ({std::min (from, to), std::max (from, to)}, walls[side.line]);
}

Side
sideOf (const PlanCell& cell, std::size_t i)
{
  return {cell.corners[i], cell.corners[(i + 1) % cell.corners.size()], cell.lines[i]};
}

/** \brief A ring without corners on straight sides. */
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

/** \brief Sides put end to end. */
PlanarRings
ringsOf (const std::vector<Side>& sides)
{
  constexpr double step = 1e-4; // [m]
  const auto key = [] (const Vector2d& place) {
    return std::pair (std::llround (place.x() / step), std::llround (place.y() / step));
  };
  std::multimap<std::pair<long long, long long>, std::size_t> by_begin;
  for (std::size_t i = 0; i < sides.size(); ++i)
    by_begin.emplace (key (sides[i].from), i);
  std::vector<char> is_used (sides.size(), 0);
  // Coordinates may be rounded apart by one step.
  const auto next_of = [&] (const Vector2d& end) -> std::optional<std::size_t> {
    const auto [x, y] = key (end);
    for (long long dx = -1; dx <= 1; ++dx)
      for (long long dy = -1; dy <= 1; ++dy) {
        const auto [first, last] = by_begin.equal_range ({x + dx, y + dy});
        for (auto found = first; found != last; ++found)
          if (!is_used[found->second])
            return found->second;
      }
    return {};
  };
  PlanarRings rings;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    PlanarPoints ring;
    for (std::optional<std::size_t> side = i; side && !is_used[*side];
         side = next_of (sides[*side].to)) {
      is_used[*side] = 1;
      ring.push_back (sides[*side].from);
    }
    if (PlanarPoints corners = withoutStraightCorners (ring); corners.size() >= 3)
      rings.push_back (std::move (corners));
  }
  return rings;
}

/** \brief Outline and holes of a room, and a place in it; no area if there is none.
 * \param[in] largest its largest cell */
PlanRoom
roomWithin (const std::vector<Side>& sides, const PlanCell& largest)
{
  constexpr double smallest_hole = 0.02; // [m^2]
  PlanarRings rings = ringsOf (sides);
  std::sort (rings.begin(), rings.end(), [] (const auto& a, const auto& b) {
    return areaOf (a) > areaOf (b);
  });
  PlanRoom room;
  for (PlanarPoints& ring : rings) {
    const double area = areaOf (ring);
    if (!room.rings.empty() && area > -smallest_hole)
      continue;
    room.area += area;
    room.rings.push_back (std::move (ring));
  }
  for (const Vector2d& corner : largest.corners)
    room.middle += corner / static_cast<double> (largest.corners.size());
  return room;
}

bool
isWithin (const PlanarPoints& ring, const Vector2d& place)
{
  bool is_within = false;
  for (std::size_t i = 0, last = ring.size() - 1; i < ring.size(); last = i++) {
    const Vector2d &a = ring[i], &b = ring[last];
    if ((a.y() > place.y()) != (b.y() > place.y()) &&
        place.x() < (b.x() - a.x()) * (place.y() - a.y()) / (b.y() - a.y()) + a.x())
      is_within = !is_within;
  }
  return is_within;
}

/** \brief The median height of the points in a ring. */
std::optional<double>
heightIn (const PlanarPoints& ring, const PlanPoints& points)
{
  Eigen::AlignedBox2d box;
  for (const Vector2d& corner : ring)
    box.extend (corner);
  std::vector<double> heights;
  for (const Eigen::Vector3d& point : points)
    if (box.contains (point.head<2>().eval()) && isWithin (ring, point.head<2>()))
      heights.push_back (point.z());
  if (heights.empty())
    return {};
  const auto middle =
      heights.begin() + static_cast<std::ptrdiff_t> (heights.size() / 2);
  std::nth_element (heights.begin(), middle, heights.end());
  return *middle;
}

Eigen::AlignedBox2d
boxAround (const std::vector<WallFace>& faces, const std::vector<WallSpan>& spans)
{
  constexpr double margin = 0.5; // [m]
  Eigen::AlignedBox2d box;
  for (const WallSpan& span : spans)
    for (const double end : {span.whole.from, span.whole.to})
      box.extend (faces[span.face].line.at (end));
  return {box.min().array() - margin, box.max().array() + margin};
}

/** \brief Lines of faces that have walls; of others the rim's, which cut nothing. */
std::vector<PlanCell>
cellsBetween (const std::vector<WallFace>& faces,
              const std::vector<Intervals>& walls,
              const Eigen::AlignedBox2d& box)
{
  std::vector<PlanLine> lines;
  for (std::size_t i = 0; i < faces.size(); ++i)
    lines.push_back (walls[i].empty()
                         ? PlanLine{box.min() - Vector2d (1.0, 1.0), Vector2d::UnitX()}
                         : faces[i].line);
  return cellsOf (box, lines);
}

} // namespace

std::vector<PlanRoom>
roomsOf (const std::vector<WallFace>& faces,
         const std::vector<WallSpan>& spans,
         const Cover& cover,
         double smallest)
{
  constexpr double least_cover = 0.5;       // of a cell that is in a room
  constexpr double least_wall = 0.5;        // of a side that divides, and of an outline
  constexpr std::size_t most_walls = 1'000; // cells grow with their square
  if (spans.empty() || spans.size() > most_walls)
    return {};
  const std::vector<Intervals> walls = wallsOnLines (faces.size(), spans);
  const Eigen::AlignedBox2d box = boxAround (faces, spans);
  const std::vector<PlanCell> cells = cellsBetween (faces, walls, box);
  const CoveredSquares squares (cover.points, box);
  std::vector<char> is_inside;
  for (const PlanCell& cell : cells)
    is_inside.push_back (squares.shareOf (cell) >= least_cover ? 1 : 0);
  CellSets sets (cells.size());
  for (const auto& [first, second, i] : commonSides (cells)) {
    const Side side = sideOf (cells[first], i);
    const double length = (side.to - side.from).norm();
    if (is_inside[first] && is_inside[second] &&
        walledLength (side, faces, walls) < least_wall * length)
      sets.join (first, second);
  }
  // Sides between a room and what is not of it.
  std::map<std::size_t, std::vector<Side>> outlines;
  std::map<std::size_t, std::size_t> largest;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> neighbors;
  for (const auto& [first, second, i] : commonSides (cells)) {
    neighbors[{first, i}] = second;
    const Side side = sideOf (cells[first], i);
    for (std::size_t j = 0; j < cells[second].corners.size(); ++j)
      if (const Side other = sideOf (cells[second], j);
          (other.from - side.to).norm() < 1e-3 && (other.to - side.from).norm() < 1e-3)
        neighbors[{second, j}] = first;
  }
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (!is_inside[c])
      continue;
    const std::size_t root = sets.rootOf (c);
    const auto known = largest.emplace (root, c).first;
    if (areaOf (cells[c].corners) > areaOf (cells[known->second].corners))
      known->second = c;
    for (std::size_t i = 0; i < cells[c].corners.size(); ++i) {
      const auto neighbor = neighbors.find ({c, i});
      if (neighbor == neighbors.end() || !is_inside[neighbor->second] ||
          sets.rootOf (neighbor->second) != root)
        outlines[root].push_back (sideOf (cells[c], i));
    }
  }
  std::vector<PlanRoom> rooms;
  for (const auto& [root, sides] : outlines) {
    double length = 0.0, walled = 0.0;
    for (const Side& side : sides) {
      length += (side.to - side.from).norm();
      walled += walledLength (side, faces, walls);
    }
    PlanRoom room = roomWithin (sides, cells[largest[root]]);
    if (room.rings.empty() || room.area < smallest || walled < least_wall * length)
      continue;
    room.enclosed = walled / length;
    room.floor = heightIn (room.rings.front(), cover.floor);
    room.ceiling = heightIn (room.rings.front(), cover.ceiling);
    rooms.push_back (std::move (room));
  }
  std::stable_sort (rooms.begin(), rooms.end(), [] (const auto& a, const auto& b) {
    return a.area > b.area;
  });
  return rooms;
}

} // namespace pcl_ops::internal
