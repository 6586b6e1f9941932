// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/angles.h"
#include "matching/patch.h"
#include "matching/pose_belief.h"
#include <pcl_ops/plane_detector.h>
#include <pcl_ops/plane_matching.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace pcl_ops {

namespace {

using namespace internal;

using Patches = std::vector<std::optional<Patch>>;

/** \brief Slopes of planes at more than this to each other are no small errors. */
constexpr double least_cosine = 0.7;

/** \brief Of three numbers with a normal distribution, 99.7 % have a smaller sum of
 * squares: three standard deviations. */
constexpr double largest_squared_distance = 14.16;

Patches
patchesOf (const std::vector<PlaneSegment>& planes)
{
  Patches patches;
  patches.reserve (planes.size());
  for (const PlaneSegment& plane : planes)
    patches.push_back (patchOf (plane));
  return patches;
}

/** \brief A pair of planes that may be one. */
struct Pair {
  std::size_t previous, current;
  /** \brief Above 0 and up to 1. */
  double score;
};

/** \brief The share of the smaller of two patches over the other, as \ref
 * PlaneMatchingParameters::min_overlap has it, and of both together. */
struct Overlap {
  double of_smaller = 0.0, of_both = 0.0;
};

Overlap
overlapOf (const Patch& fixed, const Patch& over)
{
  const double common = commonArea (fixed, over);
  if (!(common > 0.0))
    return {};
  return {common / std::min (fixed.area(), over.area()),
          common / (fixed.area() + over.area() - common)};
}

/** \return nothing for planes that cannot be one */
std::optional<Pair>
pairOf (const Patches& previous,
        std::size_t p,
        const Patches& current,
        std::size_t c,
        const PoseBelief& belief,
        double min_overlap)
{
  if (!previous[p] || !current[c])
    return std::nullopt;
  const Patch &fixed = *previous[p], &seen = *current[c];
  const Patch over = moved (belief.pose(), seen);
  if (std::abs (over.normal().dot (fixed.normal())) < least_cosine)
    return std::nullopt;
  const double distance = belief.squaredDistance (belief.mismatchOf (fixed, seen));
  if (!(distance <= largest_squared_distance))
    return std::nullopt;
  const Overlap overlap = overlapOf (fixed, over);
  constexpr double but_for_rounding = 1.0 - 1e-9;
  if (!(overlap.of_both > 0.0 && overlap.of_smaller >= but_for_rounding * min_overlap))
    return std::nullopt;
  // The root of the likelihood: frames cut a surface out differently, so that planes
  // of it differ by more than noise, and how they overlap has to count, too.
  return Pair{p, c, overlap.of_both * std::exp (-0.25 * distance)};
}

/** \brief Lets the pose follow from the planes, the largest first: the less sure it is
 * the more it needs those that cannot be mistaken. */
PoseBelief
registered (const Patches& previous,
            const Patches& current,
            PoseBelief belief,
            double min_overlap)
{
  const auto area = [&] (std::size_t c) {
    return current[c] ? current[c]->area() : 0.0;
  };
  std::vector<std::size_t> by_area (current.size());
  std::iota (by_area.begin(), by_area.end(), 0);
  std::stable_sort (by_area.begin(), by_area.end(), [&] (auto one, auto other) {
    return area (one) > area (other);
  });
  std::vector<bool> is_taken (previous.size(), false);
  for (const std::size_t c : by_area) {
    std::optional<Pair> best;
    for (std::size_t p = 0; p < previous.size(); ++p) {
      if (is_taken[p])
        continue;
      const auto pair = pairOf (previous, p, current, c, belief, min_overlap);
      if (pair && (!best || pair->score > best->score))
        best = pair;
    }
    if (!best)
      continue;
    is_taken[best->previous] = true;
    belief.update (*previous[best->previous], *current[c]);
  }
  return belief;
}

std::vector<Pair>
pairsByScore (const Patches& previous,
              const Patches& current,
              const PoseBelief& belief,
              double min_overlap)
{
  std::vector<Pair> pairs;
  for (std::size_t c = 0; c < current.size(); ++c)
    for (std::size_t p = 0; p < previous.size(); ++p)
      if (const auto pair = pairOf (previous, p, current, c, belief, min_overlap))
        pairs.push_back (*pair);
  std::stable_sort (
      pairs.begin(), pairs.end(), [] (const Pair& one, const Pair& other) {
        return one.score > other.score;
      });
  return pairs;
}

/** \brief Each plane in one pair at most, the best pairs first. */
Labels
oneToOne (const std::vector<Pair>& pairs, std::size_t previous, std::size_t current)
{
  Labels labels (current, no_plane);
  std::vector<bool> is_taken (previous, false);
  for (const Pair& pair : pairs) {
    if (labels[pair.current] != no_plane || is_taken[pair.previous])
      continue;
    labels[pair.current] = static_cast<std::int32_t> (pair.previous);
    is_taken[pair.previous] = true;
  }
  return labels;
}

} // namespace

std::string
validate (const PlaneMatchingParameters& parameters)
{
  if (!(parameters.rotation_error >= 0.0 && parameters.rotation_error <= right_angle))
    return "the rotation error must be between 0 and pi/2 (radians)";
  if (!(parameters.translation_error >= 0.0 &&
        std::isfinite (parameters.translation_error)))
    return "the translation error must be a length from 0";
  if (!(parameters.min_overlap >= 0.0 && parameters.min_overlap <= 1.0))
    return "the smallest overlap must be between 0 and 1";
  return {};
}

PlaneMatches
matchPlanes (const std::vector<PlaneSegment>& previous,
             const std::vector<PlaneSegment>& current,
             const Eigen::Isometry3d& pose,
             const PlaneMatchingParameters& parameters)
{
  detail::throwOn (validate (parameters));
  detail::throwOn (pose.matrix().allFinite() ? "" : "the pose must be finite");
  const Patches before = patchesOf (previous), now = patchesOf (current);
  const double min_overlap = parameters.min_overlap;
  const PoseBelief given (
      pose, parameters.rotation_error, parameters.translation_error);
  const PoseBelief belief = registered (before, now, given, min_overlap);
  return {oneToOne (pairsByScore (before, now, belief, min_overlap),
                    previous.size(),
                    current.size()),
          belief.pose()};
}

} // namespace pcl_ops
