// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "wall_faces.h"

#include "constants.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace pcl_ops::internal::buildings {
namespace {

/** \brief Returns the mean distance between neighboring points of a face [m]: the root
 * of area / points, with the area of the cells of a coarse grid that have points. */
double
spacingOf (const std::vector<Eigen::Vector2d>& points)
{
  std::vector<std::pair<long, long>> cells;
  for (const Eigen::Vector2d& point : points)
    cells.emplace_back (std::lround (point.x() / constants.edge_of_spacing_cell),
                        std::lround (point.y() / constants.edge_of_spacing_cell));
  std::sort (cells.begin(), cells.end());
  cells.erase (std::unique (cells.begin(), cells.end()), cells.end());
  const double area = constants.edge_of_spacing_cell * constants.edge_of_spacing_cell *
                      static_cast<double> (cells.size());
  return std::sqrt (area /
                    static_cast<double> (std::max<std::size_t> (1, points.size())));
}

bool
isParallel (const WallFace& first, const WallFace& second)
{
  return first.line.along.dot (second.line.along) >= constants.min_cosine_of_parallel;
}

/** \brief Converts intervals of a face to places on another line. */
Intervals
on (const PlanLine& line, const WallFace& face, const Intervals& intervals)
{
  Intervals moved;
  for (const Interval& interval : intervals)
    moved.push_back ({line.place (face.line.at (interval.from)),
                      line.place (face.line.at (interval.to))});
  return moved;
}

/** \brief Returns whether a face is parallel to another one and has both ends on its
 * line. */
bool
continues (const WallFace& part, const WallFace& face)
{
  if (!isParallel (part, face))
    return false;
  for (const double end : {part.seen.front().from, part.seen.back().to})
    if (std::abs (face.line.distance (part.line.at (end))) > constants.max_off_line)
      return false;
  return true;
}

void
addTo (WallFace& face, const WallFace& part)
{
  const double gap = std::max (constants.max_closed_gap, face.spacing);
  face.seen = unionOf (face.seen, on (face.line, part, part.seen), gap);
  face.cut = unionOf (face.cut, on (face.line, part, part.cut), gap);
  const double moved = face.line.place (part.line.origin);
  for (const Eigen::Vector2d& point : part.points)
    face.points.emplace_back (point.x() + moved, point.y());
  face.ends_rooms = face.ends_rooms && part.ends_rooms;
  face.planes.insert (face.planes.end(), part.planes.begin(), part.planes.end());
}

/** \brief Returns the share of a leaf, without its rim, that has points of the wall in
 * front of it, 0 to 1; 1 if the rim is all. The share is small if the points are of
 * furniture that touches the wall, and large if the leaf is the wall's other side. */
double
shareBefore (const WallFace& leaf, const WallFace& wall)
{
  const double edge =
      std::max (constants.min_edge_of_leaf_square,
                std::max (leaf.spacing, wall.spacing) / constants.squares_of_gap);
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

/** \brief Shortens intervals by noise_of_ends at both ends, and drops shorter ones.
 * Noise moves the ends of a leaf; points of the wall show better where the gap ends. */
Intervals
insideOf (const Intervals& intervals)
{
  Intervals inside;
  for (const auto& [from, to] : intervals)
    if (to - from > 2.0 * constants.noise_of_ends)
      inside.push_back ({from + constants.noise_of_ends, to - constants.noise_of_ends});
  return inside;
}

bool
isRecessOf (const WallFace& leaf, const WallFace& wall)
{
  if (!isParallel (leaf, wall) || leaf.points.size() >= wall.points.size())
    return false;
  const Interval whole{leaf.seen.front().from, leaf.seen.back().to};
  const double behind =
      -wall.line.distance (leaf.line.at (0.5 * (whole.from + whole.to)));
  if (behind < constants.min_recess || behind > constants.max_recess)
    return false;
  const Interval there{wall.line.place (leaf.line.at (whole.from)),
                       wall.line.place (leaf.line.at (whole.to))};
  return there.from >= wall.seen.front().from - constants.max_closed_gap &&
         there.to <= wall.seen.back().to + constants.max_closed_gap &&
         shareBefore (leaf, wall) <= constants.max_share_before_leaf;
}

/** \brief Returns the height of the highest point [m]. */
double
topOf (const WallFace& face)
{
  double top = face.points.front().y();
  for (const Eigen::Vector2d& point : face.points)
    top = std::max (top, point.y());
  return top;
}

/** \brief Returns whether a face stands before a wall that is seen above most of it. A
 * wall without points at the cut is of another story and does not count. */
bool
isFrontBefore (const WallFace& front, const WallFace& wall)
{
  if (wall.cut.empty() ||
      front.line.along.dot (wall.line.along) < constants.min_cosine_of_part)
    return false;
  const Interval whole{front.seen.front().from, front.seen.back().to};
  const double before =
      wall.line.distance (front.line.at (0.5 * (whole.from + whole.to)));
  if (before < constants.min_before_wall || before > constants.max_before_wall)
    return false;
  const double low = topOf (front) + constants.same_level;
  std::vector<double> above;
  for (const Eigen::Vector2d& point : wall.points)
    if (point.y() > low)
      above.push_back (point.x());
  const Interval there{wall.line.place (front.line.at (whole.from)),
                       wall.line.place (front.line.at (whole.to))};
  const double gap = std::max (constants.max_closed_gap, wall.spacing);
  return 2.0 * lengthWithin (there, intervalsOf (above, gap)) > there.length();
}

} // namespace

WallFace
faceOf (const Eigen::Vector3d& normal,
        const PlanPoints& points,
        std::size_t plane,
        double height)
{
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
  face.spacing = constants.spacings_of_gap * spacing;
  const double band =
      std::max (constants.half_band_of_wall, constants.spacings_of_band * spacing);
  std::vector<double> seen;
  std::vector<double> cut;
  for (const Eigen::Vector2d& point : face.points) {
    seen.push_back (point.x());
    if (std::abs (point.y() - height) <= band)
      cut.push_back (point.x());
  }
  const double gap = std::max (constants.max_closed_gap, face.spacing);
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
withoutFurniture (const std::vector<WallFace>& faces)
{
  std::vector<WallFace> kept;
  for (const WallFace& face : faces)
    if (std::none_of (faces.begin(), faces.end(), [&face] (const WallFace& wall) {
          return isFrontBefore (face, wall);
        }))
      kept.push_back (face);
  return kept;
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
