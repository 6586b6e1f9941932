// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ops/point_extraction.h"

#include "geometry/float_plane.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace pcl_ops::internal {

namespace {

Coordinates
gather (const Coordinates& points, const Indices& chosen)
{
  Coordinates gathered;
  gathered.x.reserve (chosen.size());
  gathered.y.reserve (chosen.size());
  gathered.z.reserve (chosen.size());
  for (const std::uint32_t i : chosen)
    gathered.add (points.x[i], points.y[i], points.z[i]);
  return gathered;
}

bool
isWithin (const Coordinates& points,
          std::size_t i,
          const Plane& plane,
          double distance_threshold)
{
  return std::abs (plane.distance (points[i])) < distance_threshold;
}

Coordinates
pointsOffPlane (const Coordinates& points, const Plane& plane, double threshold)
{
  Coordinates off;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!isWithin (points, i, plane, threshold))
      off.add (points.x[i], points.y[i], points.z[i]);
  return off;
}

} // namespace

std::size_t
countWithinDistance (const Coordinates& points,
                     const Plane& plane,
                     double distance_threshold)
{
  const auto threshold = static_cast<float> (distance_threshold);
  std::int32_t count = 0;
  forDistances (
      FloatPlane (plane), points, [&count, threshold] (std::size_t, float distance) {
        count += distance < threshold;
      });
  return static_cast<std::size_t> (count);
}

Indices
selectWithinDistance (const Coordinates& points,
                      const Indices& candidates,
                      const Plane& plane,
                      double distance_threshold)
{
  Indices inliers;
  for (const std::uint32_t i : candidates)
    if (isWithin (points, i, plane, distance_threshold))
      inliers.push_back (i);
  return inliers;
}

PointCandidates::PointCandidates (const OrientedSamples& samples,
                                  Indices candidates,
                                  const RansacParameters& parameters)
: samples_ (samples)
, candidates_ (std::move (candidates))
, parameters_ (parameters)
, gathered_ (gather (samples, candidates_))
{}

Plane
PointCandidates::planeOf (std::uint32_t candidate) const
{
  const std::uint32_t sample = candidates_[candidate];
  return planeThrough (samples_[sample], samples_.normals[sample]);
}

Vote
PointCandidates::leastVote() const
{
  const auto theta_n = static_cast<std::int32_t> (parameters_.min_inliers);
  return {theta_n, theta_n, size()};
}

Vote
PointCandidates::vote (const Plane& hypothesis) const
{
  const Coordinates& verified = remaining_ ? *remaining_ : gathered_;
  const auto count = static_cast<std::int32_t> (
      countWithinDistance (verified, hypothesis, parameters_.distance_threshold));
  return {count, count, verified.size()};
}

bool
PointCandidates::suffices (const Plane& hypothesis, const Vote& /*vote*/) const
{
  return select (hypothesis).inliers.size() > parameters_.min_inliers;
}

Support
PointCandidates::select (const Plane& plane) const
{
  Support support{plane,
                  selectWithinDistance (
                      samples_, candidates_, plane, parameters_.distance_threshold),
                  Moments()};
  for (const std::uint32_t i : support.inliers)
    support.moments.add (samples_.x[i], samples_.y[i], samples_.z[i]);
  return support;
}

void
PointCandidates::remove (const Peel& peel)
{
  Indices rest;
  std::set_difference (candidates_.begin(),
                       candidates_.end(),
                       peel.taken.begin(),
                       peel.taken.end(),
                       std::back_inserter (rest));
  candidates_ = std::move (rest);
  gathered_ = gather (samples_, candidates_);
  if (remaining_ && peel.plane)
    *remaining_ =
        pointsOffPlane (*remaining_, *peel.plane, parameters_.distance_threshold);
}

std::optional<Peel>
largestPlane (const PointCandidates& candidates,
              const RansacParameters& parameters,
              RandomGenerator& generator)
{
  const std::optional<Plane> hypothesis =
      onePointRansac (candidates, parameters.probability, generator);
  if (!hypothesis)
    return std::nullopt;
  const auto select = [&candidates] (const Plane& plane) {
    return candidates.select (plane);
  };
  Support support = parameters.local_optimization ? growSupport (*hypothesis, select)
                                                  : select (*hypothesis);
  const std::optional<PlaneFit> fit = fitPlane (support.moments);
  return Peel{std::move (support.inliers), fit ? fit->plane : support.plane};
}

} // namespace pcl_ops::internal
