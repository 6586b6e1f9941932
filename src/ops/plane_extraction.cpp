// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_ops/plane_extraction.h>

#include <cmath>
#include <limits>

namespace pcl_ops {

namespace {

Coordinates
gather (const Coordinates& positions, const Positions& chosen)
{
  Coordinates gathered;
  gathered.x.reserve (chosen.size());
  gathered.y.reserve (chosen.size());
  gathered.z.reserve (chosen.size());
  for (const std::uint32_t i : chosen)
    gathered.add (positions.x[i], positions.y[i], positions.z[i]);
  return gathered;
}

std::optional<Plane>
refit (const Coordinates& positions, const Positions& inliers)
{
  Moments moments;
  for (const std::uint32_t i : inliers)
    moments.add (positions.x[i], positions.y[i], positions.z[i]);
  const std::optional<PlaneFit> fit = fitPlane (moments);
  return fit ? std::optional<Plane> (fit->plane) : std::nullopt;
}

Coordinates
pointsOffPlane (const Coordinates& positions, const Plane& plane, double threshold)
{
  Coordinates off;
  for (std::size_t i = 0; i < positions.size(); ++i)
    if (!(std::abs (plane.distance (positions[i])) < threshold))
      off.add (positions.x[i], positions.y[i], positions.z[i]);
  return off;
}

// theta_N is counted on the samples, whatever hypotheses compete on.
bool
hasMoreInliers (const OrientedSamples& samples,
                const Positions& candidates,
                const Plane& plane,
                const RansacParameters& parameters)
{
  return selectWithinDistance (
             samples, candidates, plane, parameters.distance_threshold)
             .size() > parameters.min_inliers;
}

// Local optimisation: the refitted plane is kept as long as it finds more inliers.
ExtractedPlane
growSupport (const OrientedSamples& samples,
             const Positions& candidates,
             const Plane& hypothesis,
             const RansacParameters& parameters)
{
  ExtractedPlane best{
      hypothesis,
      selectWithinDistance (
          samples, candidates, hypothesis, parameters.distance_threshold)};
  while (parameters.local_optimisation) {
    const std::optional<Plane> refitted = refit (samples, best.inliers);
    if (!refitted)
      break;
    Positions inliers = selectWithinDistance (
        samples, candidates, *refitted, parameters.distance_threshold);
    if (inliers.size() <= best.inliers.size())
      break;
    best = ExtractedPlane{*refitted, std::move (inliers)};
  }
  best.plane = refit (samples, best.inliers).value_or (best.plane);
  return best;
}

} // namespace

std::size_t
requiredDraws (double probability, double inlier_ratio)
{
  if (!(inlier_ratio < 1.0))
    return 1;
  const double draws = std::log1p (-probability) / std::log1p (-inlier_ratio);
  constexpr auto most = static_cast<double> (std::numeric_limits<std::int32_t>::max());
  return static_cast<std::size_t> (draws > 0.0 && draws < most ? std::ceil (draws)
                                                               : most);
}

std::size_t
countWithinDistance (const Coordinates& positions,
                     const Plane& plane,
                     double distance_threshold)
{
  const Eigen::Vector3f n = plane.normal.cast<float>();
  const auto offset = static_cast<float> (plane.offset);
  const auto threshold = static_cast<float> (distance_threshold);
  const float* const x = positions.x.data();
  const float* const y = positions.y.data();
  const float* const z = positions.z.data();
  std::int32_t count = 0;
  for (std::size_t i = 0; i < positions.size(); ++i)
    count += std::abs (n.x() * x[i] + n.y() * y[i] + n.z() * z[i] + offset) < threshold;
  return static_cast<std::size_t> (count);
}

Positions
selectWithinDistance (const Coordinates& positions,
                      const Positions& candidates,
                      const Plane& plane,
                      double distance_threshold)
{
  Positions inliers;
  for (const std::uint32_t i : candidates)
    if (std::abs (plane.distance (positions[i])) < distance_threshold)
      inliers.push_back (i);
  return inliers;
}

std::optional<Plane>
onePointRansac (const OrientedSamples& samples,
                const Positions& candidates,
                const Coordinates& verified,
                const RansacParameters& parameters,
                RandomGenerator& generator)
{
  const std::size_t theta_n = parameters.min_inliers;
  if (candidates.size() <= theta_n)
    return std::nullopt;
  const auto n_h = static_cast<double> (verified.size());
  std::optional<Plane> best;
  std::size_t best_count = theta_n;
  // No plane smaller than theta_N is worth a draw: the cap of a round that finds
  // nothing.
  std::size_t n_iter = requiredDraws (parameters.probability,
                                      static_cast<double> (theta_n) /
                                          static_cast<double> (candidates.size()));
  for (std::size_t iter = 0; iter < n_iter; ++iter) {
    const std::uint32_t drawn = candidates[drawBelow (
        generator, static_cast<std::uint32_t> (candidates.size()))];
    const Plane hypothesis = planeThrough (samples[drawn], samples.normals[drawn]);
    const std::size_t count =
        countWithinDistance (verified, hypothesis, parameters.distance_threshold);
    if (count <= best_count ||
        !hasMoreInliers (samples, candidates, hypothesis, parameters))
      continue;
    best = hypothesis;
    best_count = count;
    n_iter =
        requiredDraws (parameters.probability, static_cast<double> (best_count) / n_h);
  }
  return best;
}

std::optional<ExtractedPlane>
largestPlane (const OrientedSamples& samples,
              const Positions& candidates,
              const RansacParameters& parameters,
              RandomGenerator& generator)
{
  const std::optional<Plane> hypothesis = onePointRansac (
      samples, candidates, gather (samples, candidates), parameters, generator);
  if (!hypothesis)
    return std::nullopt;
  return growSupport (samples, candidates, *hypothesis, parameters);
}

std::optional<ExtractedPlane>
largestPlane (const OrientedSamples& samples,
              const Positions& candidates,
              Coordinates& remaining,
              const RansacParameters& parameters,
              RandomGenerator& generator)
{
  const std::optional<Plane> hypothesis =
      onePointRansac (samples, candidates, remaining, parameters, generator);
  if (!hypothesis)
    return std::nullopt;
  ExtractedPlane found = growSupport (samples, candidates, *hypothesis, parameters);
  remaining = pointsOffPlane (remaining, found.plane, parameters.distance_threshold);
  return found;
}

} // namespace pcl_ops
