// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/angles.h"
#include "geometry/noise_ratios.h"
#include <pcl_ops/plane_merging.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl_ops {
using namespace detail;
using namespace internal;
namespace {

/** \brief A merged plane with the indices of the input planes merged into it. */
struct Group {
  Moments moments;
  PlaneFit fit;
  std::vector<std::size_t> members;
};

// Sorts groups by descending number of points.
void
sortByDescendingCount (std::vector<Group>& groups)
{
  std::stable_sort (
      groups.begin(), groups.end(), [] (const Group& first, const Group& second) {
        return first.moments.count > second.moments.count;
      });
}

// Makes a group of each plane whose points span a plane: points that are all equal or
// on one line do not. The groups are sorted by descending number of points.
std::vector<Group>
groupsWithAPlane (const std::vector<Moments>& planes)
{
  std::vector<Group> groups;
  for (std::size_t i = 0; i < planes.size(); ++i)
    if (const std::optional<PlaneFit> fit = fitPlane (planes[i]))
      groups.push_back ({planes[i], *fit, {i}});
  sortByDescendingCount (groups);
  return groups;
}

// Whether the noise of both groups explains the rms distance of the smaller group's
// points to the plane of the larger one. Unlike areCoplanar it tests this direction
// only. That plane has no bounds here: the groups may lie apart.
bool
agreeWithinNoise (const Group& larger, const Group& smaller, double noise_factor)
{
  // The noise of exact points is the rounding of their coordinates: 1e-6 of their
  // spread along the plane.
  constexpr double rounding_share_of_variance = 1e-12;
  const double rounding_variance = rounding_share_of_variance * larger.fit.variances[2];
  const auto [cleaner, noisier] = // squared noises [m^2]
      std::minmax (larger.fit.variances[0], smaller.fit.variances[0]);
  return meanSquaredDistance (smaller.moments, larger.fit.plane) <
         noise_factor * noise_factor *
             commonSquaredNoise (noisier + rounding_variance,
                                 cleaner + rounding_variance);
}

bool
areWithinAngle (const PlaneFit& first, const PlaneFit& second, double angle_threshold)
{
  const double cosine = std::abs (first.plane.normal.dot (second.plane.normal));
  return std::acos (std::min (1.0, cosine)) < angle_threshold;
}

// Merges a group into a larger one and refits. Does nothing and returns false if the
// points of both together span no plane.
bool
absorb (Group& larger, const Group& smaller)
{
  Moments joined = larger.moments;
  joined += smaller.moments;
  const std::optional<PlaneFit> fit = fitPlane (joined);
  if (!fit)
    return false;
  larger.moments = joined;
  larger.fit = *fit;
  larger.members.insert (
      larger.members.end(), smaller.members.begin(), smaller.members.end());
  return true;
}

// Returns the smallest absolute cosine between the normals of planes to merge, less a
// tolerance for rounding. Thousands of planes have millions of pairs: the cheap test of
// the cosine rejects most of them first.
double
minCosineWithin (double angle_threshold)
{
  constexpr double rounding = 1e-9; // far above that of a cosine, some 1e-16
  // Signs of normals do not count, so that no angle is above pi/2.
  return std::cos (std::min (angle_threshold, right_angle)) - rounding;
}

// Merges groups in one pass over all pairs.
// \param[in,out] groups by descending number of points
// \return whether any pair was merged
bool
mergeInOnePass (std::vector<Group>& groups,
                double angle_threshold,
                double distance_threshold,
                double noise_factor)
{
  const double min_cosine = minCosineWithin (angle_threshold);
  // The normals one after the other in memory: most pairs are rejected by them alone.
  std::vector<Eigen::Vector3d> normals;
  normals.reserve (groups.size());
  for (const Group& group : groups)
    normals.push_back (group.fit.plane.normal);
  std::vector<bool> is_absorbed (groups.size(), false);
  const auto absorbIfOnePlane = [&] (Group& larger, const Group& smaller) {
    const bool are_one_plane =
        areCoplanar (larger.fit, smaller.fit, angle_threshold, distance_threshold) ||
        (areWithinAngle (larger.fit, smaller.fit, angle_threshold) &&
         agreeWithinNoise (larger, smaller, noise_factor));
    return are_one_plane && absorb (larger, smaller);
  };
  std::vector<Group> kept;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    if (is_absorbed[i])
      continue;
    for (std::size_t j = i + 1; j < groups.size(); ++j)
      if (std::abs (normals[i].dot (normals[j])) > min_cosine && !is_absorbed[j] &&
          absorbIfOnePlane (groups[i], groups[j])) {
        is_absorbed[j] = true;
        normals[i] = groups[i].fit.plane.normal;
      }
    kept.push_back (std::move (groups[i]));
  }
  const bool has_merged = kept.size() < groups.size();
  groups = std::move (kept);
  sortByDescendingCount (groups);
  return has_merged;
}

} // namespace

bool
detail::areCoplanar (const PlaneFit& first,
                     const PlaneFit& second,
                     double angle_threshold,
                     double distance_threshold)
{
  return areWithinAngle (first, second, angle_threshold) &&
         std::abs (first.plane.distance (second.centroid)) < distance_threshold &&
         std::abs (second.plane.distance (first.centroid)) < distance_threshold;
}

MergedPlanes
mergePlanes (const std::vector<Moments>& planes, const MergingParameters& parameters)
{
  std::vector<Group> groups = groupsWithAPlane (planes);
  constexpr double default_distance_threshold = 0.05; // [m], MergingParameters
  while (parameters.enabled &&
         mergeInOnePass (
             groups,
             parameters.angle_threshold,
             parameters.distance_threshold.value_or (default_distance_threshold),
             parameters.noise_factor.value_or (0.0))) {
  }
  MergedPlanes merged;
  merged.merged_into.assign (planes.size(), no_plane);
  for (std::size_t g = 0; g < groups.size(); ++g) {
    merged.moments.push_back (groups[g].moments);
    merged.fits.push_back (groups[g].fit);
    for (const std::size_t member : groups[g].members)
      merged.merged_into[member] = static_cast<std::int32_t> (g);
  }
  return merged;
}

} // namespace pcl_ops
