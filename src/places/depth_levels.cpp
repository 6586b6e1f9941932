// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "places/depth_levels.h"

#include "geometry/principal_axes.h"
#include "places/constants.h"
#include <pcl_ops/plane.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace pcl_ops::internal {

namespace {

// Fewer points have no levels that would matter.
constexpr std::size_t min_points_on_levels = 2000;
constexpr std::size_t min_levels = 12;

/** \brief A point whose nearest points are flat. */
struct FlatPlace {
  Eigen::Vector3d normal;
  Eigen::Vector3d point;
};

// The flattest of some neighborhoods. Those of levels are exactly flat, or nearly so
// where coordinates were rounded later.
std::vector<FlatPlace>
flattestPlaces (const Coordinates& points, const PointTree& tree)
{
  constexpr std::size_t places = 2000;
  constexpr std::size_t neighbors = 17;
  constexpr std::size_t wanted = places / 10;
  constexpr double exact_thickness = 0.005;
  constexpr double max_thickness = 0.02;
  std::vector<std::pair<double, std::size_t>> thickness;
  std::vector<FlatPlace> all;
  NearestPoints nearest;
  for (std::size_t s = 0; s < places; ++s) {
    nearest.start (neighbors);
    tree.find (s * points.size() / places, nearest);
    Moments moments;
    moments.origin = points[nearest[0]];
    for (std::size_t k = 0; k < nearest.size(); ++k) {
      const Eigen::Vector3d p = points[nearest[k]] - moments.origin;
      moments.add (p.x(), p.y(), p.z());
    }
    const PrincipalAxes axes = principalAxes (moments.covariance());
    const double width =
        std::sqrt (squared_width_of_variance * std::max (0.0, axes.values[1]));
    if (width > 0.0)
      thickness.emplace_back (std::sqrt (std::max (0.0, axes.values[0])) / width,
                              all.size());
    all.push_back ({axes.normal, moments.origin});
  }
  if (thickness.size() < wanted)
    return {};
  std::sort (thickness.begin(), thickness.end());
  // All that are exact: faces of a model are in several directions.
  const double limit = std::max (exact_thickness, thickness[wanted - 1].first);
  std::vector<FlatPlace> flattest;
  for (const auto& [thick, place] : thickness)
    if (thick <= limit)
      flattest.push_back (all[place]);
  return limit < max_thickness ? flattest : std::vector<FlatPlace>();
}

// The direction that nearly all of the normals have, or zero. The faces of a CAD model
// have several.
Eigen::Vector3d
commonDirection (const std::vector<FlatPlace>& places)
{
  constexpr std::size_t tried = 100;
  constexpr double min_share = 0.8;
  const double min_cosine = std::cos (3.0 * M_PI / 180.0);
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();
  std::size_t most = 0;
  const std::size_t step = std::max<std::size_t> (1, places.size() / tried);
  for (std::size_t k = 0; k < places.size(); k += step) {
    std::size_t number = 0;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const auto& [normal, point] : places) {
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

/** \brief Offsets of one level, along the direction [m]. */
struct DepthLevel {
  double begin, end;
  std::size_t points;
};

// Offsets that are no farther apart than this make one level.
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

// The median distance of levels around one.
double
stepAt (const std::vector<DepthLevel>& levels, std::size_t number)
{
  constexpr std::size_t around = 2;
  const std::size_t first = number >= around ? number - around : 0;
  const std::size_t last = std::min (levels.size() - 1, number + around);
  std::vector<double> steps;
  for (std::size_t k = first; k < last; ++k)
    steps.push_back (middleOf (levels[k + 1]) - middleOf (levels[k]));
  // The lower one of two: the last level may be a wall far behind all others.
  const std::size_t middle = (steps.size() - 1) / 2;
  std::nth_element (
      steps.begin(), steps.begin() + static_cast<std::ptrdiff_t> (middle), steps.end());
  return steps[middle];
}

// Whether there are enough levels with as many points as others have: a floor and the
// leg of a chair are none. A tenth of the mean is enough.
bool
areMany (const std::vector<DepthLevel>& levels, std::size_t points)
{
  constexpr std::size_t share = 10;
  return std::count_if (levels.begin(), levels.end(), [&] (const DepthLevel& level) {
           return share * level.points * levels.size() >= points;
         }) >= static_cast<std::ptrdiff_t> (min_levels);
}

// Whether points are many a level, and most of them lie on levels that are thin for
// their distance.
bool
areLevels (const std::vector<DepthLevel>& levels, std::size_t points)
{
  constexpr std::size_t points_of_level = 50;
  constexpr double max_thickness = 0.3;
  constexpr double min_share = 0.8;
  if (levels.size() * points_of_level > points || !areMany (levels, points))
    return false;
  std::size_t thin = 0;
  for (std::size_t k = 0; k < levels.size(); ++k)
    if (levels[k].end - levels[k].begin < max_thickness * stepAt (levels, k))
      thin += levels[k].points;
  return static_cast<double> (thin) > min_share * static_cast<double> (points);
}

// The finest division of the offsets into levels, if there is one: coordinates that are
// rounded to millimeters, or jittered, have levels of some thickness.
std::vector<DepthLevel>
findLevels (const std::vector<double>& sorted)
{
  constexpr double finest = 1e-6; // of the range
  constexpr int doublings = 14;
  const double range = sorted.back() - sorted.front();
  for (int k = 0; k < doublings; ++k) {
    std::vector<DepthLevel> levels = levelsOf (sorted, std::ldexp (finest, k) * range);
    if (areLevels (levels, sorted.size()))
      return levels;
  }
  return {};
}

// The number of the level that an offset is on, or that is below it.
std::size_t
levelOf (const std::vector<DepthLevel>& levels, double offset)
{
  const auto above = std::upper_bound (
      levels.begin(), levels.end(), offset, [] (double value, const DepthLevel& level) {
        return value < level.begin;
      });
  return static_cast<std::size_t> (above - levels.begin()) - 1;
}

// Whether flat places are on several levels. Those of one exact wall are on one, and
// what is on others may be the rows of a grid.
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
  const Eigen::Vector3d direction = commonDirection (flattest);
  if (direction.isZero())
    return found;
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
