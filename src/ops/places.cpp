// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ops/places.h"

#include "base/parallel.h"
#include "cloud/all_nearest.h"
#include "cloud/point_tree.h"
#include "geometry/principal_axes.h"
#include "ops/constants.h"
#include "ops/depth_levels.h"
#include <pcl_ops/plane.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl_ops::internal {

namespace {

// The arms of a place are the places whose supports are added to its own for the next
// level. The first arms are the farthest places of its neighborhood. From level to
// level arms are about twice as far away.

// Returns the number of arms of each place; small neighborhoods have fewer than eight.
std::size_t
armCountOf (const Places& places)
{
  return std::min<std::size_t> (place_constants.arms, places.neighbors);
}

/** \brief For each place the moments of a support, about the origin of the local
 * frame. */
using Sums = std::vector<Moments>;

Sums
sumsOfNearest (const Places& places, unsigned threads)
{
  Sums sums (places.size());
  forEach (threads, places.size(), [&] (std::size_t i) {
    const Eigen::Vector3d& own = places.position[i];
    sums[i].add (own.x(), own.y(), own.z());
    for (std::size_t k = 0; k < places.neighbors; ++k) {
      const Eigen::Vector3d& other = places.position[places.nearestOf (i)[k]];
      sums[i].add (other.x(), other.y(), other.z());
    }
  });
  return sums;
}

// Adds the variance of quantized depth: that of a uniform distribution over the step of
// each point, along the depth direction. Random offsets within the steps would add the
// same on average, but would change if a point is missing.
void
addSteps (const Places& places, const DepthLevels& levels, unsigned threads, Sums& sums)
{
  if (levels.step.empty())
    return;
  const Eigen::Vector3d& d = levels.direction;
  // The products for a variance of 1 along the direction, in the order of Moments.
  const std::array<double, 6> products{d.x() * d.x(),
                                       d.x() * d.y(),
                                       d.x() * d.z(),
                                       d.y() * d.y(),
                                       d.y() * d.z(),
                                       d.z() * d.z()};
  const auto squaredStep = [&] (std::size_t i) {
    return static_cast<double> (levels.step[i]) * levels.step[i];
  };
  forEach (threads, places.size(), [&] (std::size_t i) {
    double sum = squaredStep (i);
    for (std::size_t k = 0; k < places.neighbors; ++k)
      sum += squaredStep (places.nearestOf (i)[k]);
    for (std::size_t p = 0; p < products.size(); ++p)
      sums[i].products[p] += sum / squared_width_of_variance * products[p];
  });
}

// \param[in] points number of independent points of the support
Support
supportOf (const PrincipalAxes& axes, double points)
{
  constexpr double parameters_of_plane = 3.0;
  const double correction = points / (points - parameters_of_plane);
  const Eigen::Vector3d variances = axes.values.cwiseMax (0.0);
  const double scatter = std::sqrt (variances[0] * correction);
  const double width = std::sqrt (squared_width_of_variance * variances[1]);
  Support support;
  support.normal = axes.normal.cast<float>();
  support.scatter = static_cast<float> (scatter);
  support.width = static_cast<float> (width);
  support.is_flat = scatter < place_constants.max_thickness * width &&
                    variances[1] > place_constants.min_slimness * variances[2];
  return support;
}

// Computes the principal axes of many supports side by side, which is faster.
std::vector<Support>
supportsOf (const Sums& sums, double points, unsigned threads)
{
  constexpr std::size_t at_once = 64;
  std::vector<Support> supports (sums.size());
  parallelFor (threads, sums.size(), at_once, [&] (std::size_t begin, std::size_t end) {
    std::array<Eigen::Matrix3d, at_once> matrices;
    matrices.fill (Eigen::Matrix3d::Zero());
    std::array<PrincipalAxes, at_once> axes;
    for (std::size_t i = begin; i < end; ++i)
      matrices[i - begin] = sums[i].covariance();
    principalAxes (matrices.data(), end - begin, axes.data());
    for (std::size_t i = begin; i < end; ++i)
      supports[i] = supportOf (axes[i - begin], points);
  });
  return supports;
}

// Returns the sums of each place plus the sums of its arms.
Sums
addArms (const Sums& sums,
         const Indices& arms,
         std::size_t arms_of_place,
         unsigned threads)
{
  Sums added (sums);
  forEach (threads, sums.size(), [&] (std::size_t i) {
    for (std::size_t k = 0; k < arms_of_place; ++k)
      added[i].addAligned (sums[arms[i * arms_of_place + k]]);
  });
  return added;
}

// Returns the arms for level 1: the farthest of the nearest points of each place.
Indices
firstArms (const Places& places, std::size_t arms_of_place, unsigned threads)
{
  Indices arms (places.size() * arms_of_place);
  forEach (threads, places.size(), [&] (std::size_t i) {
    std::copy_n (places.nearestOf (i) + places.neighbors - arms_of_place,
                 arms_of_place,
                 arms.data() + i * arms_of_place);
  });
  return arms;
}

/** \brief The positions of the arms of a place, side by side. Single lookups took a
 * quarter of the time of the whole detection. If there are fewer than eight arms, the
 * last one is repeated. */
struct ArmEnds {
  static constexpr std::size_t size = place_constants.arms;
  std::array<float, size> x, y, z;
};

std::vector<ArmEnds>
endsOf (const Coordinates& points,
        const Indices& arms,
        std::size_t arms_of_place,
        unsigned threads)
{
  std::vector<ArmEnds> ends (points.size());
  forEach (threads, points.size(), [&] (std::size_t i) {
    for (std::size_t q = 0; q < ArmEnds::size; ++q) {
      const std::uint32_t end =
          arms[i * arms_of_place + std::min (q, arms_of_place - 1)];
      ends[i].x[q] = points.x[end];
      ends[i].y[q] = points.y[end];
      ends[i].z[q] = points.z[end];
    }
  });
  return ends;
}

// Returns the number of the end farthest from a point, the first one in case of a tie.
std::size_t
farthestOf (const ArmEnds& ends, float x, float y, float z)
{
  std::array<float, ArmEnds::size> squared;
  for (std::size_t q = 0; q < ArmEnds::size; ++q) {
    const float dx = ends.x[q] - x;
    const float dy = ends.y[q] - y;
    const float dz = ends.z[q] - z;
    squared[q] = dx * dx + dy * dy + dz * dz;
  }
  // Take the maximum in a tree of pairs: in a sequential loop each comparison would
  // wait for the one before.
  std::array<float, ArmEnds::size> largest = squared;
  for (std::size_t half = ArmEnds::size / 2; half > 0; half /= 2)
    for (std::size_t q = 0; q < half; ++q)
      largest[q] = std::max (largest[q], largest[q + half]);
  std::size_t farthest = 0;
  for (std::size_t q = ArmEnds::size; q-- > 0;)
    farthest = squared[q] == largest[0] ? q : farthest;
  return farthest;
}

// Returns the arms of the next level: replaces each arm of a place by the arm of that
// arm which is farthest from the place.
Indices
longerArms (const Coordinates& points,
            const Indices& arms,
            std::size_t arms_of_place,
            unsigned threads)
{
  const std::vector<ArmEnds> ends = endsOf (points, arms, arms_of_place, threads);
  Indices longer (arms.size());
  forEach (threads, points.size(), [&] (std::size_t i) {
    for (std::size_t k = i * arms_of_place; k < (i + 1) * arms_of_place; ++k) {
      const std::size_t arm = arms[k];
      const std::size_t end =
          farthestOf (ends[arm], points.x[i], points.y[i], points.z[i]);
      longer[k] = arms[arm * arms_of_place + end];
    }
  });
  return longer;
}

// Returns how many independent points a support of each level counts as. Levels end
// where this would exceed max_share_of_points of all points; there are at least two.
std::vector<double>
pointsOfLevels (const Places& places)
{
  std::vector<double> points{static_cast<double> (places.neighbors + 1)};
  const double most =
      place_constants.max_share_of_points * static_cast<double> (places.size());
  while (
      static_cast<int> (points.size()) < place_constants.max_levels &&
      (points.size() < 2 || points.back() * place_constants.points_per_level <= most))
    points.push_back (points.back() * place_constants.points_per_level);
  return points;
}

// Returns the points with their depth levels moved closer together. Levels are farther
// apart than the points on them: otherwise neighborhoods would lie within one level.
Coordinates
withNearerLevels (const Coordinates& points, const DepthLevels& levels)
{
  Coordinates nearer;
  nearer.resize (points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d point = points[i];
    const double excess =
        (1.0 - place_constants.depth_of_levels) * levels.direction.dot (point);
    const Eigen::Vector3f moved = (point - excess * levels.direction).cast<float>();
    nearer.x[i] = moved.x();
    nearer.y[i] = moved.y();
    nearer.z[i] = moved.z();
  }
  return nearer;
}

// Computes the supports of all levels, from the smallest to the largest.
void
addSupports (const Coordinates& points,
             const DepthLevels& levels,
             unsigned threads,
             Places& places)
{
  const std::size_t arms_of_place = armCountOf (places);
  places.points_of_level = pointsOfLevels (places);
  Sums sums = sumsOfNearest (places, threads);
  addSteps (places, levels, threads, sums);
  Indices arms = firstArms (places, arms_of_place, threads);
  for (std::size_t level = 0; level < places.points_of_level.size(); ++level) {
    if (level > 1)
      arms = longerArms (points, arms, arms_of_place, threads);
    if (level > 0)
      sums = addArms (sums, arms, arms_of_place, threads);
    places.supports.push_back (
        supportsOf (sums, places.points_of_level[level], threads));
  }
}

} // namespace

std::size_t
neighborsOfCloud (double points, double factor)
{
  // A plane fits any three points: the scatter of fewer than six says little.
  constexpr double least = 6.0;
  const double usual = place_constants.min_neighbors *
                       std::pow (points / place_constants.neighbors_cloud,
                                 place_constants.neighbors_growth);
  const double wanted = std::round (
      factor *
      std::clamp (usual, place_constants.min_neighbors, place_constants.max_neighbors));
  return static_cast<std::size_t> (
      std::clamp (wanted, least, static_cast<double> (NearestPoints::max_size)));
}

Places
describePlaces (const Coordinates& points, std::size_t neighbors, unsigned threads)
{
  Places places;
  places.neighbors = neighbors - 1;
  places.position.resize (points.size());
  forEach (
      threads, points.size(), [&] (std::size_t i) { places.position[i] = points[i]; });
  PointTree tree (points, threads);
  const DepthLevels levels = findDepthLevels (points, tree);
  if (!levels.step.empty())
    tree = PointTree (withNearerLevels (points, levels), threads);
  places.nearest = findAllNearest (tree, places.neighbors, threads);
  addSupports (points, levels, threads, places);
  places.density.resize (points.size());
  forEach (threads, points.size(), [&] (std::size_t i) {
    constexpr float least_area = 1e-30F; // avoids a division by 0
    const float width = places.supports[0][i].width;
    places.density[i] = static_cast<float> (neighbors) / (width * width + least_area);
  });
  return places;
}

} // namespace pcl_ops::internal
