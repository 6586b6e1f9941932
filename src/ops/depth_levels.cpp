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
#include <tuple>
#include <utility>

namespace pcl_ops::internal {

namespace {

// If depth is quantized, nearly all small neighborhoods lie within one level. They are
// flat, whatever the surface, and have a common normal, the direction of depth. Along
// it the coordinates of points form narrow groups, the levels. A single wall has one
// normal, too, but only one level; a CAD model has levels, but several normals.
//
// Numbers in this file for which no reason is given were chosen by hand.

// Clouds with fewer points, or fewer full levels, are taken to have no levels.
constexpr std::size_t min_points = 2000;
constexpr std::size_t min_levels = 12;

/** \brief The plane fit to a point and its nearest points. */
struct FlatPatch {
  Eigen::Vector3d normal; // either of the two unit normals; zero for points on a line
  Eigen::Vector3d point;
  double width; // of the nearest points, in the narrower direction in the plane [m]
  double rms;   // of the distances of the nearest points to the plane [m]
};

/** \brief The thickness of a patch is FlatPatch::rms over FlatPatch::width. */
struct PatchThickness {
  double thickness;
  std::size_t patch; // index in the list of patches

  bool
  operator<(const PatchThickness& other) const
  {
    return std::tie (thickness, patch) < std::tie (other.thickness, other.patch);
  }
};

// Returns count points: a query point and those nearest to it, nearest first.
// \param[in] position of the query point in PointTree::order
std::vector<Eigen::Vector3d>
pointsAround (const Coordinates& points,
              const PointTree& tree,
              std::size_t position,
              std::size_t count)
{
  NearestPoints found;
  found.start (count);
  tree.find (position, found);
  std::vector<Eigen::Vector3d> nearest;
  for (std::size_t k = 0; k < found.size(); ++k)
    nearest.push_back (points[found[k]]);
  return nearest;
}

// Fits a plane to points, of which the first is FlatPatch::point.
FlatPatch
patchOf (const std::vector<Eigen::Vector3d>& nearest)
{
  Moments moments;
  moments.origin = nearest.front();
  for (const Eigen::Vector3d& point : nearest) {
    const Eigen::Vector3d p = point - moments.origin;
    moments.add (p.x(), p.y(), p.z());
  }
  const PrincipalAxes axes = principalAxes (moments.covariance());
  return {axes.normal,
          nearest.front(),
          std::sqrt (squared_width_of_variance * axes.values[1]),
          std::sqrt (axes.values[0])};
}

// Refits the normal of a patch to those of more nearest points that lie on its plane.
// If coordinates were rounded, the normal of few points is off by degrees: the
// direction of dense levels would stay .1 degrees off the one in which they are
// sharpest.
void
refitNormal (const std::vector<Eigen::Vector3d>& nearest, FlatPatch& patch)
{
  constexpr double max_distance = 3.0; // from the plane, in units of FlatPatch::rms
  // More than a quarter of the points must lie on the plane.
  const std::size_t quarter = nearest.size() / 4;
  std::vector<Eigen::Vector3d> on_plane;
  for (const Eigen::Vector3d& point : nearest)
    if (std::abs (patch.normal.dot (point - patch.point)) <= max_distance * patch.rms)
      on_plane.push_back (point);
  if (on_plane.size() > quarter)
    patch.normal = patchOf (on_plane).normal;
}

constexpr std::size_t tried_patches = 2000; // limits the time

// Returns the position in PointTree::order of the point of a patch. Neighbors in this
// order are neighbors in space, so that the patches are spread over the cloud.
std::size_t
positionOf (std::size_t patch, std::size_t points)
{
  return patch * points / tried_patches;
}

// Returns the thickness of the patches that have a width, the flattest patch first.
std::vector<PatchThickness>
sortedThicknesses (const std::vector<FlatPatch>& patches)
{
  std::vector<PatchThickness> thicknesses;
  for (std::size_t k = 0; k < patches.size(); ++k)
    if (patches[k].width > 0.0)
      thicknesses.push_back ({patches[k].rms / patches[k].width, k});
  std::sort (thicknesses.begin(), thicknesses.end());
  return thicknesses;
}

// Returns the flattest tenth of 2000 patches spread over the cloud, and all exactly
// flat ones; empty if this tenth is not flat. Patches on levels are exactly flat, or
// nearly so if coordinates were rounded later.
std::vector<FlatPatch>
flattestPatches (const Coordinates& points, const PointTree& tree)
{
  constexpr std::size_t wanted_patches = tried_patches / 10;
  constexpr std::size_t points_of_patch = 17;
  constexpr std::size_t points_of_refit = 100;
  constexpr double exact_thickness = 0.005; // thinner patches are exactly flat
  constexpr double max_thickness = 0.06;    // thicker patches are not flat
  std::vector<FlatPatch> patches;
  for (std::size_t k = 0; k < tried_patches; ++k)
    patches.push_back (patchOf (
        pointsAround (points, tree, positionOf (k, points.size()), points_of_patch)));
  const std::vector<PatchThickness> thicknesses = sortedThicknesses (patches);
  if (thicknesses.size() < wanted_patches)
    return {};
  // Keep all exact patches: the faces of a CAD model must show their several normals.
  const double limit =
      std::max (exact_thickness, thicknesses[wanted_patches - 1].thickness);
  if (limit >= max_thickness)
    return {};
  std::vector<FlatPatch> flattest;
  for (const auto& [thickness, k] : thicknesses) {
    if (thickness > limit)
      break;
    if (thickness > exact_thickness)
      refitNormal (
          pointsAround (points, tree, positionOf (k, points.size()), points_of_refit),
          patches[k]);
    flattest.push_back (patches[k]);
  }
  return flattest;
}

// Returns the mean direction of the largest group of similar normals, with either sign;
// zero if fewer than 80 % of the normals are in this group, as for the faces of CAD
// models. A group has all normals near one of them, its center.
Eigen::Vector3d
commonDirection (const std::vector<FlatPatch>& patches)
{
  constexpr std::size_t tried_centers = 100; // up to twice as many are tried
  constexpr double min_share = 0.8;          // of the normals in the largest group
  // From the center of a group to its other normals: 3 degrees at most.
  const double min_cosine = std::cos (3.0 * M_PI / 180.0);
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();
  std::size_t largest_group = 0;
  const std::size_t patches_per_center =
      std::max<std::size_t> (1, patches.size() / tried_centers);
  for (std::size_t center = 0; center < patches.size(); center += patches_per_center) {
    std::size_t normals_of_group = 0;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const FlatPatch& patch : patches) {
      const double cosine = patch.normal.dot (patches[center].normal);
      if (std::abs (cosine) <= min_cosine)
        continue;
      ++normals_of_group;
      sum += cosine > 0.0 ? patch.normal : Eigen::Vector3d (-patch.normal);
    }
    if (normals_of_group > largest_group) {
      largest_group = normals_of_group;
      direction = sum.normalized();
    }
  }
  if (static_cast<double> (largest_group) <
      min_share * static_cast<double> (patches.size()))
    direction.setZero();
  return direction;
}

// Returns how blurred levels are along a direction: the sum of the square roots of the
// gaps between successive offsets of the points along it [m^0.5]. If levels are exactly
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

// Searches near a start direction for the one along which levels are least blurred:
// tries rotations to four sides by ever smaller angles (pattern search). If coordinates
// were rounded, the start is off by tenths of a degree, too much for levels that are
// meters wide.
Eigen::Vector3d
sharpestDirection (const Coordinates& points, Eigen::Vector3d direction)
{
  constexpr std::size_t sample_size = 4000; // limits the time, as does max_moves
  constexpr int max_moves = 8;              // by each angle
  std::vector<Eigen::Vector3d> sample;
  for (std::size_t s = 0; s < sample_size; ++s)
    sample.push_back (points[s * points.size() / sample_size]);
  double least_blur = blurOf (sample, direction);
  for (const double degrees : {0.2, 0.1, 0.05, 0.025, 0.0125})
    for (int move = 0; move < max_moves; ++move) {
      const Eigen::Vector3d u = direction.unitOrthogonal();
      const Eigen::Vector3d before = direction;
      const Eigen::Vector3d v = before.cross (u);
      for (const Eigen::Vector3d& side :
           {u, v, Eigen::Vector3d (-u), Eigen::Vector3d (-v)}) {
        const Eigen::Vector3d moved =
            (before + degrees * M_PI / 180.0 * side).normalized();
        const double blur = blurOf (sample, moved);
        if (blur < least_blur) {
          least_blur = blur;
          direction = moved;
        }
      }
      if (direction == before)
        break;
    }
  return direction;
}

/** \brief One level. An offset is the coordinate of a point along the direction. */
struct OffsetRange {
  double begin, end;  // smallest and largest offset of the points of the level [m]
  std::size_t points; // number of them
};

// Divides ascending offsets [m] into levels at gaps larger than max_gap [m].
std::vector<OffsetRange>
levelsOf (const std::vector<double>& sorted_offsets, double max_gap)
{
  std::vector<OffsetRange> levels;
  for (const double offset : sorted_offsets)
    if (levels.empty() || offset > levels.back().end + max_gap)
      levels.push_back ({offset, offset, 1});
    else {
      levels.back().end = offset;
      ++levels.back().points;
    }
  return levels;
}

double
middleOf (const OffsetRange& level)
{
  return 0.5 * (level.begin + level.end);
}

// Returns the median distance [m] between adjacent levels near one of them, from its
// second level below to its second level above.
// \param[in] levels at least two
// \param[in] index of the level in levels
double
stepAt (const std::vector<OffsetRange>& levels, std::size_t index)
{
  constexpr std::size_t levels_aside = 2; // on either side
  const std::size_t first = index >= levels_aside ? index - levels_aside : 0;
  const std::size_t last = std::min (levels.size() - 1, index + levels_aside);
  std::vector<double> steps;
  for (std::size_t k = first; k < last; ++k)
    steps.push_back (middleOf (levels[k + 1]) - middleOf (levels[k]));
  // The lower of two middle values: the upper one may be the distance to a wall far
  // behind the others.
  const std::size_t middle = (steps.size() - 1) / 2;
  std::nth_element (
      steps.begin(), steps.begin() + static_cast<std::ptrdiff_t> (middle), steps.end());
  return steps[middle];
}

// Whether at least min_levels levels are full. A full level has at least a tenth of the
// mean number of points of a level. A floor and the legs of chairs make one full level
// and many others.
bool
hasEnoughFullLevels (const std::vector<OffsetRange>& levels, std::size_t points)
{
  const auto full_levels =
      std::count_if (levels.begin(), levels.end(), [&] (const OffsetRange& level) {
        return 10 * level.points * levels.size() >= points;
      });
  return full_levels >= static_cast<std::ptrdiff_t> (min_levels);
}

// Returns the share of the points that are on thin levels. A level is thin if it is
// much thinner than the distance to adjacent levels. Returns 0 if there are too few
// levels or too few points per level.
// \param[in] points number of points on all levels
double
shareOnThinLevels (const std::vector<OffsetRange>& levels, std::size_t points)
{
  constexpr std::size_t min_mean_points = 50; // of a level
  constexpr double max_thickness = 0.3;       // in units of the result of stepAt
  if (levels.size() * min_mean_points > points || !hasEnoughFullLevels (levels, points))
    return 0.0;
  std::size_t points_on_thin = 0;
  for (std::size_t k = 0; k < levels.size(); ++k)
    if (levels[k].end - levels[k].begin < max_thickness * stepAt (levels, k))
      points_on_thin += levels[k].points;
  return static_cast<double> (points_on_thin) / static_cast<double> (points);
}

// Divides ascending offsets [m] into levels, at the gap for which the largest share of
// points is on thin levels; empty if no share exceeds 80 %. Tries several gaps: levels
// of rounded or jittered coordinates have some thickness, and a too small gap would
// divide them.
std::vector<OffsetRange>
findLevels (const std::vector<double>& sorted_offsets)
{
  constexpr double min_share = 0.8;
  constexpr double smallest_gap = 1e-6; // in units of the range of offsets
  constexpr int tried_gaps = 14;        // each is twice the one before
  const double range = sorted_offsets.back() - sorted_offsets.front();
  double largest_share = min_share;
  std::vector<OffsetRange> best_levels;
  for (int doublings = 0; doublings < tried_gaps; ++doublings) {
    std::vector<OffsetRange> levels =
        levelsOf (sorted_offsets, std::ldexp (smallest_gap, doublings) * range);
    const double share = shareOnThinLevels (levels, sorted_offsets.size());
    if (share > largest_share) {
      largest_share = share;
      best_levels = std::move (levels);
    }
  }
  return best_levels;
}

// Returns the index of the level that contains an offset; between two levels, the index
// of the lower one. The offset must not be below the first level.
std::size_t
levelIndexOf (const std::vector<OffsetRange>& levels, double offset)
{
  const auto above = std::upper_bound (
      levels.begin(),
      levels.end(),
      offset,
      [] (double value, const OffsetRange& level) { return value < level.begin; });
  return static_cast<std::size_t> (above - levels.begin()) - 1;
}

// Whether the flat patches are on several levels. If they are all on one level, it is
// an exact wall, and the other levels may be the rows of a grid of points.
bool
areOnSeveralLevels (const std::vector<FlatPatch>& patches,
                    const std::vector<OffsetRange>& levels,
                    const Eigen::Vector3d& direction)
{
  constexpr std::size_t min_levels_with_patches = 3;
  std::set<std::size_t> levels_with_patches;
  for (const FlatPatch& patch : patches)
    levels_with_patches.insert (levelIndexOf (levels, direction.dot (patch.point)));
  return levels_with_patches.size() >= min_levels_with_patches;
}

} // namespace

DepthLevels
findDepthLevels (const Coordinates& points, const PointTree& tree)
{
  DepthLevels found;
  if (points.size() < min_points)
    return found;
  const std::vector<FlatPatch> flattest = flattestPatches (points, tree);
  const Eigen::Vector3d common = commonDirection (flattest);
  if (common.isZero())
    return found;
  const Eigen::Vector3d direction = sharpestDirection (points, common);
  std::vector<double> offsets (points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    offsets[i] = direction.dot (points[i]);
  std::vector<double> sorted_offsets (offsets);
  std::sort (sorted_offsets.begin(), sorted_offsets.end());
  const std::vector<OffsetRange> levels = findLevels (sorted_offsets);
  if (levels.empty() || !areOnSeveralLevels (flattest, levels, direction))
    return found;
  std::vector<float> step_of_level (levels.size());
  for (std::size_t k = 0; k < levels.size(); ++k)
    step_of_level[k] = static_cast<float> (stepAt (levels, k));
  found.direction = direction;
  found.step.resize (points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    found.step[i] = step_of_level[levelIndexOf (levels, offsets[i])];
  return found;
}

} // namespace pcl_ops::internal
