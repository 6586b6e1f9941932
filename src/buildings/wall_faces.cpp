// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "wall_faces.h"

#include "constants.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace pcl_ops::internal::buildings {
namespace {

/** \brief A square of a grid on a face, by column along the line and row upwards. */
using FaceSquare = std::pair<long, long>;

/** \brief Returns the mean distance between neighboring points of a face [m]: the root
 * of area / number of points. The area is that of the squares of a coarse grid that
 * have points. */
double
spacingOf (const std::vector<FacePoint>& points)
{
  std::vector<FaceSquare> squares;
  for (const FacePoint& point : points)
    squares.emplace_back (
        std::lround (point.position / constants.edge_of_spacing_square),
        std::lround (point.height / constants.edge_of_spacing_square));
  std::sort (squares.begin(), squares.end());
  squares.erase (std::unique (squares.begin(), squares.end()), squares.end());
  const double area = constants.edge_of_spacing_square *
                      constants.edge_of_spacing_square *
                      static_cast<double> (squares.size());
  return std::sqrt (area /
                    static_cast<double> (std::max<std::size_t> (1, points.size())));
}

/** \brief Returns whether two faces are parallel and have their fronts on the same
 * side, unlike the two sides of a wall. */
bool
facesSameWay (const WallFace& first, const WallFace& second)
{
  return first.line.along.dot (second.line.along) >= constants.min_cosine_of_parallel;
}

/** \brief Returns intervals of the line of a face as intervals of another line.
 * \param[in] line the other line; it runs nearly the same way */
Intervals
onLine (const PlanLine& line, const WallFace& face, const Intervals& intervals)
{
  Intervals converted;
  for (const Interval& interval : intervals)
    converted.push_back ({line.positionOf (face.line.at (interval.from)),
                          line.positionOf (face.line.at (interval.to))});
  return converted;
}

/** \brief Returns the length of the longest gaps of a face that are closed [m]. */
double
maxClosedGap (const WallFace& face)
{
  return std::max (constants.max_closed_gap, face.longest_spacing);
}

/** \brief Returns whether a part faces the same way as another face and has both its
 * ends on the line of that face. */
bool
continues (const WallFace& part, const WallFace& face)
{
  if (!facesSameWay (part, face))
    return false;
  for (const double end : {part.seen.front().from, part.seen.back().to})
    if (std::abs (face.line.distance (part.line.at (end))) > constants.max_off_line)
      return false;
  return true;
}

/** \brief Returns how far the middle of a face lies behind a wall [m]. */
double
distanceBehind (const WallFace& wall, const WallFace& face)
{
  const double middle = 0.5 * (face.seen.front().from + face.seen.back().to);
  return -wall.line.distance (face.line.at (middle));
}

/** \brief Adds \p part, which continues \p face, to \p face. */
void
addPart (WallFace& face, const WallFace& part)
{
  const double gap = maxClosedGap (face);
  face.seen = unionOf (face.seen, onLine (face.line, part, part.seen), gap);
  face.at_cut = unionOf (face.at_cut, onLine (face.line, part, part.at_cut), gap);
  const double shift = face.line.positionOf (part.line.origin);
  for (const FacePoint& point : part.points)
    face.points.push_back ({point.position + shift, point.height});
  face.ends_rooms = face.ends_rooms && part.ends_rooms;
  for (const auto& [plane, extent] : part.extent_of_plane)
    face.extent_of_plane[plane] = onLine (face.line, part, {extent}).front();
}

/** \brief Returns the squares that have points of a face.
 * \param[in] shift added to the positions of its points along the line [m]
 * \param[in] edge of a square [m] */
std::set<FaceSquare>
squaresOf (const WallFace& face, double shift, double edge)
{
  std::set<FaceSquare> squares;
  for (const FacePoint& point : face.points)
    squares.emplace (std::lround ((point.position + shift) / edge),
                     std::lround (point.height / edge));
  return squares;
}

/** \brief Returns the share of the area of a leaf, without the squares at its rim, that
 * has points of the wall in front of it, 0 to 1; 1 if all squares are at the rim. The
 * share is small if these points are of furniture that touches the wall, and large if
 * the supposed leaf is the other side of the wall. */
double
shareBehindWall (const WallFace& leaf, const WallFace& wall)
{
  const double edge = std::max (constants.min_edge_of_leaf_square,
                                std::max (leaf.longest_spacing, wall.longest_spacing) /
                                    constants.squares_of_gap);
  const std::set<FaceSquare> of_wall = squaresOf (wall, 0.0, edge);
  const std::set<FaceSquare> of_leaf =
      squaresOf (leaf, wall.line.positionOf (leaf.line.origin), edge);
  const auto is_at_rim = [&of_leaf] (const FaceSquare& square) {
    const auto [x, y] = square;
    return of_leaf.count ({x - 1, y}) == 0 || of_leaf.count ({x + 1, y}) == 0 ||
           of_leaf.count ({x, y - 1}) == 0 || of_leaf.count ({x, y + 1}) == 0;
  };
  double squares = 0.0;
  double squares_behind_wall = 0.0;
  for (const FaceSquare& square : of_leaf) {
    if (is_at_rim (square))
      continue;
    squares += 1.0;
    squares_behind_wall += of_wall.count (square) > 0 ? 1.0 : 0.0;
  }
  return squares > 0.0 ? squares_behind_wall / squares : 1.0;
}

/** \brief Returns intervals of a leaf shortened by noise_of_ends at both ends, without
 * those too short for that. Noise moves the ends of a leaf; points of the wall show
 * better where the gap ends. */
Intervals
withoutNoisyEnds (const Intervals& intervals)
{
  Intervals shortened;
  for (const auto& [from, to] : intervals)
    if (to - from > 2.0 * constants.noise_of_ends)
      shortened.push_back (
          {from + constants.noise_of_ends, to - constants.noise_of_ends});
  return shortened;
}

/** \brief Returns whether a face is a door leaf or a window pane set back in a gap of a
 * wall. */
bool
isRecessOf (const WallFace& leaf, const WallFace& wall)
{
  if (!facesSameWay (leaf, wall) || leaf.points.size() >= wall.points.size())
    return false;
  const Interval whole{leaf.seen.front().from, leaf.seen.back().to};
  const double distance_behind_wall = distanceBehind (wall, leaf);
  if (distance_behind_wall < constants.min_recess ||
      distance_behind_wall > constants.max_recess)
    return false;
  const Interval on_wall{wall.line.positionOf (leaf.line.at (whole.from)),
                         wall.line.positionOf (leaf.line.at (whole.to))};
  const bool is_between_ends =
      on_wall.from >= wall.seen.front().from - constants.max_closed_gap &&
      on_wall.to <= wall.seen.back().to + constants.max_closed_gap;
  return is_between_ends &&
         shareBehindWall (leaf, wall) <= constants.max_share_before_leaf;
}

/** \brief Returns the height of the highest point of a face [m]. */
double
topOf (const WallFace& face)
{
  double top = face.points.front().height;
  for (const FacePoint& point : face.points)
    top = std::max (top, point.height);
  return top;
}

/** \brief Returns whether points of a wall were seen above most of the length of a
 * parallel face. */
bool
isSeenAbove (const WallFace& wall, const WallFace& face)
{
  const double min_height = topOf (face) + constants.min_above_top;
  std::vector<double> seen_above;
  for (const FacePoint& point : wall.points)
    if (point.height > min_height)
      seen_above.push_back (point.position);
  const Interval on_wall{wall.line.positionOf (face.line.at (face.seen.front().from)),
                         wall.line.positionOf (face.line.at (face.seen.back().to))};
  const double length_below_seen =
      coveredLength (on_wall, intervalsOf (seen_above, maxClosedGap (wall)));
  return 2.0 * length_below_seen > on_wall.length();
}

/** \brief Returns whether a wall surrounds a leaf: the leaf is set back in a gap of it,
 * and the wall was seen above the leaf, and at the height of the cut within
 * max_closed_gap of both its ends. A part of the wall itself that lies behind the rest,
 * as drift puts it, has no such wall around it. */
bool
surrounds (const WallFace& wall, const WallFace& leaf)
{
  if (!isRecessOf (leaf, wall) || !isSeenAbove (wall, leaf))
    return false;
  const double from = wall.line.positionOf (leaf.line.at (leaf.seen.front().from));
  const double to = wall.line.positionOf (leaf.line.at (leaf.seen.back().to));
  return coveredLength ({from - constants.max_closed_gap, from}, wall.at_cut) > 0.0 &&
         coveredLength ({to, to + constants.max_closed_gap}, wall.at_cut) > 0.0;
}

/** \brief Returns whether a face stands at an end of a supposed leaf, faces it, and was
 * seen in most of the first meter before the wall of the leaf.
 * \param[in] end position along the line of the leaf [m]
 * \param[in] inwards 1 if the leaf begins at this end, -1 if it ends there */
bool
standsAtEnd (const WallFace& side,
             const WallFace& leaf,
             const WallFace& wall,
             double end,
             double inwards)
{
  const double cosine = inwards * side.line.normal().dot (leaf.line.along);
  if (cosine < constants.min_sine_of_meeting)
    return false;
  // Along the leaf, from its end to where the side crosses its line [m].
  const double off_end = side.line.distance (leaf.line.at (end)) / cosine;
  if (std::abs (off_end) > constants.max_closed_gap)
    return false;
  Intervals before_wall; // distances from the wall
  for (const Interval& seen : side.seen) {
    const auto [from, to] = std::minmax ({wall.line.distance (side.line.at (seen.from)),
                                          wall.line.distance (side.line.at (seen.to))});
    before_wall.push_back ({from, to});
  }
  return 2.0 * coveredLength ({0.0, constants.min_wall_width}, before_wall) >
         constants.min_wall_width;
}

/** \brief Returns whether a supposed leaf of a wall is the end of a room between two
 * other rooms, whose walls end before it: the sides of the room stand at both its ends,
 * and the wall does not go on above it, as it does above a door at the end of a
 * corridor. */
bool
isEndOfRoom (const WallFace& leaf,
             const WallFace& wall,
             const std::vector<WallFace>& faces)
{
  const auto has_side_at = [&] (double end, double inwards) {
    return std::any_of (faces.begin(), faces.end(), [&] (const WallFace& side) {
      return standsAtEnd (side, leaf, wall, end, inwards);
    });
  };
  return has_side_at (leaf.seen.front().from, 1.0) &&
         has_side_at (leaf.seen.back().to, -1.0) && !isSeenAbove (wall, leaf);
}

/** \brief Returns whether a front stands before a wall, and points of the wall were
 * seen above most of the length of the front. A wall without points at the cut is of
 * another story and does not count. */
bool
isFrontBefore (const WallFace& front, const WallFace& wall)
{
  if (wall.at_cut.empty() ||
      front.line.along.dot (wall.line.along) < constants.min_cosine_of_part)
    return false;
  const Interval whole{front.seen.front().from, front.seen.back().to};
  const double distance_before_wall =
      wall.line.distance (front.line.at (0.5 * (whole.from + whole.to)));
  if (distance_before_wall < constants.min_before_wall ||
      distance_before_wall > constants.max_before_wall)
    return false;
  return isSeenAbove (wall, front);
}

/** \brief Adds faces that are set back to the faces they continue, unless these
 * surround them: then they are leaves, faces of their own. */
void
joinSetBack (std::vector<WallFace> set_back, std::vector<WallFace>& joined)
{
  for (WallFace& face : set_back) {
    const auto larger = std::find_if (
        joined.begin(), joined.end(), [&face] (const WallFace& candidate) {
          return continues (face, candidate) && !surrounds (candidate, face);
        });
    if (larger == joined.end())
      joined.push_back (std::move (face));
    else
      addPart (*larger, face);
  }
}

} // namespace

WallFace
faceOf (const Eigen::Vector3d& normal,
        const PlanPoints& points,
        std::size_t plane_index,
        double height_of_cut)
{
  WallFace face;
  const Eigen::Vector2d front = normal.head<2>().normalized();
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (const Eigen::Vector3d& point : points)
    middle += point.head<2>() / static_cast<double> (points.size());
  face.line = {middle, {front.y(), -front.x()}};
  for (const Eigen::Vector3d& point : points)
    face.points.push_back ({face.line.positionOf (point.head<2>()), point.z()});
  const double spacing = spacingOf (face.points);
  face.longest_spacing = constants.spacings_of_gap * spacing;
  const double half_band =
      std::max (constants.half_band_of_wall, constants.spacings_of_band * spacing);
  std::vector<double> seen; // positions along the line [m]
  std::vector<double> at_cut;
  for (const FacePoint& point : face.points) {
    seen.push_back (point.position);
    if (std::abs (point.height - height_of_cut) <= half_band)
      at_cut.push_back (point.position);
  }
  face.seen = intervalsOf (seen, maxClosedGap (face));
  face.at_cut = intervalsOf (at_cut, maxClosedGap (face));
  face.extent_of_plane[plane_index] =
      face.seen.empty() ? Interval{0.0, 0.0}
                        : Interval{face.seen.front().from, face.seen.back().to};
  return face;
}

std::vector<WallFace>
joinFaces (std::vector<WallFace> faces)
{
  // Larger faces come first, so that smaller ones are added to them.
  std::sort (faces.begin(), faces.end(), [] (const WallFace& a, const WallFace& b) {
    return a.points.size() != b.points.size() ? a.points.size() > b.points.size()
                                              : a.firstPlane() < b.firstPlane();
  });
  std::vector<WallFace> joined;
  // Whether a wall surrounds a leaf shows when all parts of the wall are joined, such
  // as a lintel, which is smaller than the leaf.
  std::vector<WallFace> set_back;
  for (WallFace& face : faces) {
    if (face.seen.empty())
      continue;
    const auto larger = std::find_if (
        joined.begin(), joined.end(), [&face] (const WallFace& candidate) {
          return continues (face, candidate);
        });
    if (larger == joined.end())
      joined.push_back (std::move (face));
    else if (distanceBehind (*larger, face) >= constants.min_recess)
      set_back.push_back (std::move (face));
    else
      addPart (*larger, face);
  }
  joinSetBack (std::move (set_back), joined);
  std::sort (joined.begin(), joined.end(), [] (const WallFace& a, const WallFace& b) {
    return a.firstPlane() < b.firstPlane();
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
        std::any_of (faces.begin(), faces.end(), [&] (const WallFace& wall) {
          return isRecessOf (face, wall) && !isEndOfRoom (face, wall, faces);
        });
    (is_recess ? leaves : kept).push_back (face);
  }
  for (WallFace& wall : kept)
    for (const WallFace& leaf : leaves)
      if (!leaf.seen.empty() && isRecessOf (leaf, wall)) {
        const Intervals seen_at_cut =
            withoutNoisyEnds (onLine (wall.line, leaf, leaf.at_cut));
        wall.at_cut = without (wall.at_cut, seen_at_cut);
        wall.leaves = unionOf (wall.leaves, seen_at_cut, 0.0);
      }
  return kept;
}

} // namespace pcl_ops::internal::buildings
