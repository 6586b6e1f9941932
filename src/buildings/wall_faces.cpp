// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "wall_faces.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace pcl_ops::internal::buildings {
namespace {

constexpr double same_direction = 0.9976; // cosine of 4 degrees

/** \brief Gaps up to this are closed, whatever the density [m]. */
constexpr double smallest_gap = 0.25;

/** \brief Mean distance between neighboring points of a face, by the cells of a coarse
 * grid that have points. */
double
spacingOf (const std::vector<Eigen::Vector2d>& points)
{
  constexpr double cell = 0.25; // [m]
  std::vector<std::pair<long, long>> cells;
  for (const Eigen::Vector2d& point : points)
    cells.emplace_back (std::lround (point.x() / cell), std::lround (point.y() / cell));
  std::sort (cells.begin(), cells.end());
  cells.erase (std::unique (cells.begin(), cells.end()), cells.end());
  const double area = cell * cell * static_cast<double> (cells.size());
  return std::sqrt (area /
                    static_cast<double> (std::max<std::size_t> (1, points.size())));
}

bool
isParallel (const WallFace& first, const WallFace& second)
{
  return first.line.along.dot (second.line.along) >= same_direction;
}

/** \brief Intervals of a face by places on the line of another one. */
Intervals
on (const PlanLine& line, const WallFace& face, const Intervals& intervals)
{
  Intervals moved;
  for (const Interval& interval : intervals)
    moved.push_back ({line.place (face.line.at (interval.from)),
                      line.place (face.line.at (interval.to))});
  return moved;
}

/** \brief Whether both ends of a face are on the line of another one. */
bool
continues (const WallFace& part, const WallFace& face)
{
  constexpr double farthest = 0.05; // thinner than the recess of a door [m]
  if (!isParallel (part, face))
    return false;
  for (const double end : {part.seen.front().from, part.seen.back().to})
    if (std::abs (face.line.distance (part.line.at (end))) > farthest)
      return false;
  return true;
}

void
addTo (WallFace& face, const WallFace& part)
{
  const double gap = std::max (smallest_gap, face.spacing);
  face.seen = unionOf (face.seen, on (face.line, part, part.seen), gap);
  face.cut = unionOf (face.cut, on (face.line, part, part.cut), gap);
  const double moved = face.line.place (part.line.origin);
  for (const Eigen::Vector2d& point : part.points)
    face.points.emplace_back (point.x() + moved, point.y());
  face.planes.insert (face.planes.end(), part.planes.begin(), part.planes.end());
}

/** \brief How much of what is seen of a leaf, without its rim, has points of the wall
 * before it, 0 to 1: few of furniture that touches the wall, many of its other side. */
double
shareBefore (const WallFace& leaf, const WallFace& wall)
{
  constexpr double smallest = 0.1; // edge of a square [m]
  const double edge = std::max ({smallest, leaf.spacing / 3.0, wall.spacing / 3.0});
  using Square = std::pair<long, long>;
  const auto squares_of = [edge] (const WallFace& face, double moved) {
    std::set<Square> squares;
    for (const Eigen::Vector2d& point : face.points)
      squares.emplace (std::lround ((point.x() + moved) / edge),
                       std::lround (point.y() / edge));
    return squares;
  };
  const std::set<Square> of_wall = squares_of (wall, 0.0);
  const std::set<Square> of_leaf =
      squares_of (leaf, wall.line.place (leaf.line.origin));
  const auto is_at_rim = [&of_leaf] (const Square& square) {
    const auto [x, y] = square;
    return of_leaf.count ({x - 1, y}) == 0 || of_leaf.count ({x + 1, y}) == 0 ||
           of_leaf.count ({x, y - 1}) == 0 || of_leaf.count ({x, y + 1}) == 0;
  };
  double all = 0.0;
  double common = 0.0;
  for (const Square& square : of_leaf) {
    if (is_at_rim (square))
      continue;
    all += 1.0;
    common += of_wall.count (square) > 0 ? 1.0 : 0.0;
  }
  return all > 0.0 ? common / all : 1.0;
}

/** \brief Without their ends, which noise moves and the wall itself tells better. */
Intervals
insideOf (const Intervals& intervals)
{
  constexpr double noise = 0.02; // [m]
  Intervals inside;
  for (const auto& [from, to] : intervals)
    if (to - from > 2.0 * noise)
      inside.push_back ({from + noise, to - noise});
  return inside;
}

bool
isRecessOf (const WallFace& leaf, const WallFace& wall)
{
  constexpr double deepest = 0.45;
  constexpr double flattest = 0.02; // [m]
  constexpr double max_covered = 0.6;
  if (!isParallel (leaf, wall) || leaf.points.size() >= wall.points.size())
    return false;
  const Interval whole{leaf.seen.front().from, leaf.seen.back().to};
  const double behind =
      -wall.line.distance (leaf.line.at (0.5 * (whole.from + whole.to)));
  if (behind < flattest || behind > deepest)
    return false;
  const Interval there{wall.line.place (leaf.line.at (whole.from)),
                       wall.line.place (leaf.line.at (whole.to))};
  return there.from >= wall.seen.front().from - smallest_gap &&
         there.to <= wall.seen.back().to + smallest_gap &&
         shareBefore (leaf, wall) <= max_covered;
}

} // namespace

WallFace
faceOf (const Eigen::Vector3d& normal,
        const PlanPoints& points,
        std::size_t plane,
        double height)
{
  constexpr double spacings_of_gap = 6.0;
  constexpr double half_band = 0.05; // [m]
  WallFace face;
  face.planes = {plane};
  const Eigen::Vector2d front = normal.head<2>().normalized();
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (const Eigen::Vector3d& point : points)
    middle += point.head<2>() / static_cast<double> (points.size());
  face.line = {middle, {front.y(), -front.x()}};
  for (const Eigen::Vector3d& point : points)
    face.points.emplace_back (face.line.place (point.head<2>()), point.z());
  const double spacing = spacingOf (face.points);
  face.spacing = spacings_of_gap * spacing;
  const double band = std::max (half_band, 3.0 * spacing);
  std::vector<double> seen;
  std::vector<double> cut;
  for (const Eigen::Vector2d& point : face.points) {
    seen.push_back (point.x());
    if (std::abs (point.y() - height) <= band)
      cut.push_back (point.x());
  }
  const double gap = std::max (smallest_gap, face.spacing);
  face.seen = intervalsOf (seen, gap);
  face.cut = intervalsOf (cut, gap);
  return face;
}

std::vector<WallFace>
joinFaces (std::vector<WallFace> faces)
{
  std::sort (faces.begin(), faces.end(), [] (const WallFace& a, const WallFace& b) {
    return a.points.size() != b.points.size() ? a.points.size() > b.points.size()
                                              : a.planes < b.planes;
  });
  std::vector<WallFace> joined;
  for (WallFace& face : faces) {
    if (face.seen.empty())
      continue;
    const auto whole = std::find_if (
        joined.begin(), joined.end(), [&face] (const WallFace& candidate) {
          return continues (face, candidate);
        });
    if (whole == joined.end())
      joined.push_back (std::move (face));
    else
      addTo (*whole, face);
  }
  for (WallFace& face : joined)
    std::sort (face.planes.begin(), face.planes.end());
  std::sort (joined.begin(), joined.end(), [] (const WallFace& a, const WallFace& b) {
    return a.planes < b.planes;
  });
  return joined;
}

std::vector<WallFace>
withoutRecesses (const std::vector<WallFace>& faces,
                 const std::vector<WallFace>& upright)
{
  std::vector<WallFace> kept;
  std::vector<WallFace> leaves = upright;
  for (const WallFace& face : faces) {
    const bool is_recess =
        std::any_of (faces.begin(), faces.end(), [&face] (const WallFace& wall) {
          return isRecessOf (face, wall);
        });
    (is_recess ? leaves : kept).push_back (face);
  }
  for (WallFace& wall : kept)
    for (const WallFace& leaf : leaves)
      if (!leaf.seen.empty() && isRecessOf (leaf, wall))
        wall.cut = without (wall.cut, insideOf (on (wall.line, leaf, leaf.cut)));
  return kept;
}

} // namespace pcl_ops::internal::buildings
