// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "paper/point_extraction.h"

#include "geometry/float_plane.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <utility>

namespace pcl_ops::internal {

namespace {

bool
isNearPlane (const Coordinates& points,
             std::size_t i,
             const Plane& plane,
             double distance_threshold)
{
  return std::abs (plane.distance (points[i])) < distance_threshold;
}

Coordinates
pointsOffPlane (const Coordinates& points, const Plane& plane, double threshold)
{
  Coordinates off_plane;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!isNearPlane (points, i, plane, threshold))
      off_plane.add (points.x[i], points.y[i], points.z[i]);
  return off_plane;
}

std::optional<PlaneFit>
fitTo (const Coordinates& points, const Indices& inliers)
{
  Moments moments;
  for (const std::uint32_t i : inliers)
    moments.add (points.x[i], points.y[i], points.z[i]);
  return fitPlane (moments);
}

// Removes the inliers of a plane from the free samples, and the points near it from the
// free points.
void
removeTaken (const ExtractedPlane& found, double threshold, Candidates& candidates)
{
  Indices still_free;
  std::set_difference (candidates.free_samples.begin(),
                       candidates.free_samples.end(),
                       found.inliers.begin(),
                       found.inliers.end(),
                       std::back_inserter (still_free));
  candidates.free_samples = std::move (still_free);
  if (candidates.free_points)
    *candidates.free_points =
        pointsOffPlane (*candidates.free_points, found.plane, threshold);
}

} // namespace

std::size_t
requiredDraws (double probability, double inlier_ratio)
{
  if (!(inlier_ratio < 1.0))
    return 1;
  const double draws = std::log1p (-probability) / std::log1p (-inlier_ratio);
  constexpr auto max_draws =
      static_cast<double> (std::numeric_limits<std::int32_t>::max());
  const bool is_in_range = draws > 0.0 && draws < max_draws;
  return static_cast<std::size_t> (is_in_range ? std::ceil (draws) : max_draws);
}

std::size_t
countWithinDistance (const Coordinates& points,
                     const Plane& plane,
                     double distance_threshold)
{
  const auto threshold = static_cast<float> (distance_threshold);
  std::int32_t count = 0;
  const auto add = [&count, threshold] (std::size_t, float distance) {
    count += distance < threshold;
  };
  forDistances (FloatPlane (plane), points, 0, points.size(), add);
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
    if (isNearPlane (points, i, plane, distance_threshold))
      inliers.push_back (i);
  return inliers;
}

std::optional<Plane>
onePointRansac (const Candidates& candidates,
                const RansacParameters& parameters,
                RandomGenerator& generator)
{
  const auto& [samples, free_samples, free_points] = candidates;
  if (free_samples.size() <= parameters.min_samples)
    return std::nullopt;
  const auto drawsFor = [&] (std::size_t inliers, std::size_t among) {
    return requiredDraws (parameters.paper_only.probability,
                          static_cast<double> (inliers) / static_cast<double> (among));
  };
  const Coordinates positions_of_free_samples = selected (samples, free_samples);
  // The points among which inliers of hypotheses are counted.
  const Coordinates& counted_points =
      free_points ? *free_points : positions_of_free_samples;
  std::optional<Plane> best;
  // Planes of theta_N samples or fewer do not count: N_iter starts with the draws for
  // theta_N inliers, so that the search ends where there is no plane.
  std::size_t most_inliers = parameters.min_samples;
  std::size_t n_iter = drawsFor (most_inliers, free_samples.size());
  for (std::size_t iter = 0; iter < n_iter; ++iter) {
    const std::uint32_t drawn = free_samples[drawBelow (
        generator, static_cast<std::uint32_t> (free_samples.size()))];
    const Plane hypothesis = planeThrough (samples[drawn], samples.normals[drawn]);
    const double theta_h = *parameters.distance_threshold;
    const std::size_t inlier_count =
        countWithinDistance (counted_points, hypothesis, theta_h);
    if (inlier_count <= most_inliers)
      continue;
    const Indices inliers =
        selectWithinDistance (samples, free_samples, hypothesis, theta_h);
    if (inliers.size() <= parameters.min_samples)
      continue;
    best = hypothesis;
    most_inliers = inlier_count;
    n_iter = drawsFor (inlier_count, counted_points.size());
  }
  return best;
}

std::optional<ExtractedPlane>
largestPlane (const Candidates& candidates,
              const RansacParameters& parameters,
              RandomGenerator& generator)
{
  const std::optional<Plane> hypothesis =
      onePointRansac (candidates, parameters, generator);
  if (!hypothesis)
    return std::nullopt;
  const auto select = [&] (const Plane& plane) {
    return selectWithinDistance (candidates.samples,
                                 candidates.free_samples,
                                 plane,
                                 *parameters.distance_threshold);
  };
  ExtractedPlane found{*hypothesis, select (*hypothesis)};
  while (const auto fit = fitTo (candidates.samples, found.inliers)) {
    found.plane = fit->plane;
    if (!parameters.paper_only.local_optimization)
      break;
    Indices selected = select (found.plane);
    if (selected.size() <= found.inliers.size())
      break;
    found.inliers = std::move (selected);
  }
  return found;
}

std::vector<ExtractedPlane>
extractAll (Candidates& candidates,
            const RansacParameters& parameters,
            RandomGenerator& generator)
{
  std::vector<ExtractedPlane> planes;
  while (auto found = largestPlane (candidates, parameters, generator)) {
    removeTaken (*found, *parameters.distance_threshold, candidates);
    planes.push_back (std::move (*found));
  }
  return planes;
}

} // namespace pcl_ops::internal
