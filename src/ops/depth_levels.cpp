// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ops/depth_levels.h"

#include <Eigen/Geometry>

#include "geometry/principal_axes.h"
#include "ops/constants.h"
#include <pcl_ops/plane.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace pcl_ops::internal {

namespace {

// If depth is quantized, nearly all small neighborhoods lie within one level. They are
// flat, whatever the surface, and have a common normal, the direction of depth. Along
// it the coordinates of points form narrow groups, the levels. A single wall has one
// normal, too, but only one level; a CAD model has levels, but several normals.

// Clouds with fewer points, or fewer levels, are taken to have no levels.
constexpr std::size_t min_points_on_levels = 2000;
constexpr std::size_t min_levels = 12;

/** \brief The plane fit to the nearest points of a point. */
struct FlatPlace {
  Eigen::Vector3d normal;
  Eigen::Vector3d point;
  double width; // extent of the nearest points in their narrower direction [m]
  double rms;   // of their distances to the plane [m]
};

// Returns a number of nearest points, the query itself first.
// \param[in] position of the query in PointTree::order
std::vector<Eigen::Vector3d>
pointsAround (const Coordinates& points,
              const PointTree& tree,
              std::size_t position,
              std::size_t number)
{
  NearestPoints found;
  found.start (number);
  tree.find (position, found);
  std::vector<Eigen::Vector3d> nearest;
  for (std::size_t k = 0; k < found.size(); ++k)
    nearest.push_back (points[found[k]]);
  return nearest;
}

FlatPlace
flatPlaceOf (const std::vector<Eigen::Vector3d>& nearest)
{
  Moments moments;
  moments.origin = nearest.front();
  for (const Eigen::Vector3d& point : nearest) {
    const Eigen::Vector3d p = point - moments.origin;
    moments.add (p.x(), p.y(), p.z());
  }
  const PrincipalAxes axes = principalAxes (moments.covariance());
  // Rounding can make a variance of 0 negative.
  return {axes.normal,
          nearest.front(),
          std::sqrt (squared_width_of_variance * std::max (0.0, axes.values[1])),
          std::sqrt (std::max (0.0, axes.values[0]))};
}

// Refits the normal of a flat place to more nearest points that lie on its plane. If
// coordinates were rounded, the normal of few points is off by degrees: the direction
// of dense levels would stay .1 degrees off the one in which they are sharpest.
void
straighten (const std::vector<Eigen::Vector3d>& nearest, FlatPlace& place)
{
  constexpr double rms_within = 3.0;
  std::vector<Eigen::Vector3d> on_plane;
  for (const Eigen::Vector3d& point : nearest)
    if (std::abs (place.normal.dot (point - place.point)) <= rms_within * place.rms)
      on_plane.push_back (point);
  if (on_plane.size() > nearest.size() / 4)
    place.normal = flatPlaceOf (on_plane).normal;
}

// Returns the flattest tenth of 2000 neighborhoods spread over the cloud, and all
// exactly flat ones; empty if this tenth is not flat. Neighborhoods on levels are
// exactly flat, or nearly so if coordinates were rounded later.
std::vector<FlatPlace>
flattestPlaces (const Coordinates& points, const PointTree& tree)
{
  constexpr std::size_t tried = 2000;
  constexpr std::size_t wanted = tried / 10;
  constexpr std::size_t neighbors = 17; // the point itself included
  constexpr std::size_t more_neighbors = 100;
  // Both thicknesses are the rms distance to the plane over the width.
  constexpr double exact_thickness = 0.005;
  constexpr double max_thickness = 0.06;
  const auto positionOf = [&] (std::size_t k) { return k * points.size() / tried; };
  std::vector<std::pair<double, std::size_t>> by_thickness;
  std::vector<FlatPlace> places;
  for (std::size_t k = 0; k < tried; ++k) {
    places.push_back (
        flatPlaceOf (pointsAround (points, tree, positionOf (k), neighbors)));
    if (places[k].width > 0.0)
      by_thickness.emplace_back (places[k].rms / places[k].width, k);
  }
  if (by_thickness.size() < wanted)
    return {};
  std::sort (by_thickness.begin(), by_thickness.end());
  // Keep all exact places: the faces of a CAD model must show their several normals.
  const double limit = std::max (exact_thickness, by_thickness[wanted - 1].first);
  if (limit >= max_thickness)
    return {};
  std::vector<FlatPlace> flattest;
  for (const auto& [thickness, k] : by_thickness) {
    if (thickness > limit)
      break;
    if (thickness > exact_thickness)
      straighten (pointsAround (points, tree, positionOf (k), more_neighbors),
                  places[k]);
    flattest.push_back (places[k]);
  }
  return flattest;
}

// Returns the mean direction of the largest group of similar normals, up to the sign;
// zero if fewer than 80 % are in it, as for the faces of CAD models.
Eigen::Vector3d
commonDirection (const std::vector<FlatPlace>& places)
{
  constexpr std::size_t tried = 100; // normals as the center of a group
  constexpr double min_share = 0.8;
  const double min_cosine = std::cos (3.0 * M_PI / 180.0);
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();
  std::size_t most = 0;
  const std::size_t step = std::max<std::size_t> (1, places.size() / tried);
  for (std::size_t k = 0; k < places.size(); k += step) {
    std::size_t number = 0;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const FlatPlace& place : places) {
      const Eigen::Vector3d& normal = place.normal;
      const double cosine = normal.dot (places[k].normal);
      if (std::abs (cosine) <= min_cosine)
        continue;
      ++number;
      sum += cosine > 0.0 ? normal : Eigen::Vector3d (-normal);
    }
    if (number > most) {
      most = number;
      direction = sum.normalized();
    }
  }
  if (static_cast<double> (most) < min_share * static_cast<double> (places.size()))
    direction.setZero();
  return direction;
}

// Measures how blurred levels are along a direction: sorts the offsets of points along
// it and sums the square roots of the gaps between them. If levels are exactly
// perpendicular to the direction, most gaps are zero.
double
blurOf (const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& direction)
{
  std::vector<double> offsets;
  offsets.reserve (points.size());
  for (const Eigen::Vector3d& point : points)
    offsets.push_back (direction.dot (point));
  std::sort (offsets.begin(), offsets.end());
  double sum = 0.0;
  for (std::size_t k = 1; k < offsets.size(); ++k)
    sum += std::sqrt (offsets[k] - offsets[k - 1]);
  return sum;
}

// Searches near a direction for the one along which levels are least blurred: pattern
// search with ever smaller rotations to four sides. The start is off by tenths of a
// degree if coordinates were rounded, too much for levels that are meters wide.
Eigen::Vector3d
sharpened (const Coordinates& points, Eigen::Vector3d direction)
{
  constexpr std::size_t looked_at = 4000;
  constexpr int max_moves = 8; // for each angle
  std::vector<Eigen::Vector3d> some;
  for (std::size_t s = 0; s < looked_at; ++s)
    some.push_back (points[s * points.size() / looked_at]);
  double least = blurOf (some, direction);
  for (const double degrees : {0.2, 0.1, 0.05, 0.025, 0.0125})
    for (int move = 0; move < max_moves; ++move) {
      const Eigen::Vector3d u = direction.unitOrthogonal();
      const Eigen::Vector3d before = direction;
      const Eigen::Vector3d v = before.cross (u);
      for (const Eigen::Vector3d& side :
           {u, v, Eigen::Vector3d (-u), Eigen::Vector3d (-v)}) {
        const Eigen::Vector3d moved =
            (before + degrees * M_PI / 180.0 * side).normalized();
        const double blur = blurOf (some, moved);
        if (blur < least) {
          least = blur;
          direction = moved;
        }
      }
      if (direction == before)
        break;
    }
  return direction;
}

/** \brief One level: the range of the offsets of its points along the direction [m]. */
struct DepthLevel {
  double begin, end;
  std::size_t points;
};

// Divides sorted offsets [m] into levels at gaps larger than max_gap [m].
std::vector<DepthLevel>
levelsOf (const std::vector<double>& sorted, double max_gap)
{
  std::vector<DepthLevel> levels;
  for (const double offset : sorted)
    if (levels.empty() || offset > levels.back().end + max_gap)
      levels.push_back ({offset, offset, 1});
    else {
      levels.back().end = offset;
      ++levels.back().points;
    }
  return levels;
}

double
middleOf (const DepthLevel& level)
{
  return 0.5 * (level.begin + level.end);
}

// Returns the median distance between adjacent levels around a level [m]; at least two
// levels are needed.
double
stepAt (const std::vector<DepthLevel>& levels, std::size_t number)
{
  constexpr std::size_t around = 2; // levels to either side
  const std::size_t first = number >= around ? number - around : 0;
  const std::size_t last = std::min (levels.size() - 1, number + around);
  std::vector<double> steps;
  for (std::size_t k = first; k < last; ++k)
    steps.push_back (middleOf (levels[k + 1]) - middleOf (levels[k]));
  // The lower of two middle values: the last level may be a wall far behind the others.
  const std::size_t middle = (steps.size() - 1) / 2;
  std::nth_element (
      steps.begin(), steps.begin() + static_cast<std::ptrdiff_t> (middle), steps.end());
  return steps[middle];
}

// Whether at least min_levels levels have a tenth of the mean number of points of a
// level or more. A floor and the legs of chairs, with far fewer points, do not.
bool
areMany (const std::vector<DepthLevel>& levels, std::size_t points)
{
  constexpr std::size_t part_of_mean = 10;
  const auto counted =
      std::count_if (levels.begin(), levels.end(), [&] (const DepthLevel& level) {
        return part_of_mean * level.points * levels.size() >= points;
      });
  return counted >= static_cast<std::ptrdiff_t> (min_levels);
}

// Returns the share of the points on thin levels: levels that are thin for their
// distance to adjacent ones; 0 if there are too few levels or too few points per level.
double
shareOnThinLevels (const std::vector<DepthLevel>& levels, std::size_t points)
{
  constexpr std::size_t min_points_of_level = 50; // in the mean
  constexpr double max_thickness = 0.3;           // over stepAt
  if (levels.size() * min_points_of_level > points || !areMany (levels, points))
    return 0.0;
  std::size_t thin = 0;
  for (std::size_t k = 0; k < levels.size(); ++k)
    if (levels[k].end - levels[k].begin < max_thickness * stepAt (levels, k))
      thin += levels[k].points;
  return static_cast<double> (thin) / static_cast<double> (points);
}

// Returns the division of sorted offsets into levels with the largest share of points
// on thin levels; empty if no share exceeds 80 %. Tries several gaps: levels of rounded
// or jittered coordinates have some thickness, and a too small gap would cut them up.
std::vector<DepthLevel>
findLevels (const std::vector<double>& sorted)
{
  constexpr double min_share = 0.8;
  constexpr double smallest_gap = 1e-6; // of the range
  constexpr int gaps = 14;              // each twice the last one
  const double range = sorted.back() - sorted.front();
  double largest_share = min_share;
  std::vector<DepthLevel> best_levels;
  for (int k = 0; k < gaps; ++k) {
    std::vector<DepthLevel> levels =
        levelsOf (sorted, std::ldexp (smallest_gap, k) * range);
    const double share = shareOnThinLevels (levels, sorted.size());
    if (share > largest_share) {
      largest_share = share;
      best_levels = std::move (levels);
    }
  }
  return best_levels;
}

// Returns the number of the level of an offset; between two levels, that of the lower
// one. The offset must not be below the first level.
std::size_t
levelOf (const std::vector<DepthLevel>& levels, double offset)
{
  const auto above = std::upper_bound (
      levels.begin(), levels.end(), offset, [] (double value, const DepthLevel& level) {
        return value < level.begin;
      });
  return static_cast<std::size_t> (above - levels.begin()) - 1;
}

// Whether the flat places are on several levels. If they are all on one level, it is an
// exact wall, and the other levels may be the rows of a grid of points.
bool
areSeenFlat (const std::vector<DepthLevel>& levels,
             const std::vector<FlatPlace>& places,
             const Eigen::Vector3d& direction)
{
  constexpr std::size_t min_flat_levels = 3;
  std::set<std::size_t> flat;
  for (const FlatPlace& place : places)
    flat.insert (levelOf (levels, direction.dot (place.point)));
  return flat.size() >= min_flat_levels;
}

} // namespace

DepthLevels
findDepthLevels (const Coordinates& points, const PointTree& tree)
{
  DepthLevels found;
  if (points.size() < min_points_on_levels)
    return found;
  const std::vector<FlatPlace> flattest = flattestPlaces (points, tree);
  const Eigen::Vector3d common = commonDirection (flattest);
  if (common.isZero())
    return found;
  const Eigen::Vector3d direction = sharpened (points, common);
  std::vector<double> offset (points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    offset[i] = direction.dot (points[i]);
  std::vector<double> sorted (offset);
  std::sort (sorted.begin(), sorted.end());
  const std::vector<DepthLevel> levels = findLevels (sorted);
  if (levels.empty() || !areSeenFlat (levels, flattest, direction))
    return found;
  std::vector<float> steps (levels.size());
  for (std::size_t k = 0; k < levels.size(); ++k)
    steps[k] = static_cast<float> (stepAt (levels, k));
  found.direction = direction;
  found.step.resize (points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    found.step[i] = steps[levelOf (levels, offset[i])];
  return found;
}

} // namespace pcl_ops::internal
