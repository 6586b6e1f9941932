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
// level: see describePlaces.

// Returns the number of arms of each place. Neighborhoods of fewer than eight neighbors
// have fewer arms.
std::size_t
armsPerPlace (const Places& places)
{
  return std::min<std::size_t> (place_constants.arms, places.neighbors_per_place);
}

/** \brief For each place the moments of a support, about the origin of the local
 * frame. */
using PlaceMoments = std::vector<Moments>;

// Returns the moments of the supports of level 0.
PlaceMoments
momentsOfNeighborhoods (const Places& places, unsigned threads)
{
  PlaceMoments moments (places.size());
  forEach (threads, places.size(), [&] (std::size_t i) {
    const Eigen::Vector3d& own = places.position[i];
    moments[i].add (own.x(), own.y(), own.z());
    for (std::size_t k = 0; k < places.neighbors_per_place; ++k) {
      const Eigen::Vector3d& other = places.position[places.nearestOf (i)[k]];
      moments[i].add (other.x(), other.y(), other.z());
    }
  });
  return moments;
}

// Adds the variance of quantized depth: for each point the variance of a uniform
// distribution along the depth direction, as wide as the step between depth levels.
// Random offsets of the points within these steps would add the same variance on
// average, but other points would get other offsets if one point is missing.
void
addQuantization (const Places& places,
                 const DepthLevels& levels,
                 unsigned threads,
                 PlaceMoments& moments)
{
  if (levels.step.empty())
    return;
  const Eigen::Vector3d& d = levels.direction;
  // Moments::products of one point at a distance of 1 along the direction.
  const std::array<double, 6> unit_products{d.x() * d.x(),
                                            d.x() * d.y(),
                                            d.x() * d.z(),
                                            d.y() * d.y(),
                                            d.y() * d.z(),
                                            d.z() * d.z()};
  const auto squaredStep = [&] (std::size_t i) {
    return static_cast<double> (levels.step[i]) * levels.step[i];
  };
  forEach (threads, places.size(), [&] (std::size_t i) {
    double squared_steps = squaredStep (i);
    for (std::size_t k = 0; k < places.neighbors_per_place; ++k)
      squared_steps += squaredStep (places.nearestOf (i)[k]);
    for (std::size_t product = 0; product < unit_products.size(); ++product)
      moments[i].products[product] +=
          squared_steps / squared_width_of_variance * unit_products[product];
  });
}

// Makes a support from the principal axes of the covariance of its points.
// \param[in] independent_points how many the support counts as, Places::points_of_level
Support
supportOf (const PrincipalAxes& axes, double independent_points)
{
  const double correction =
      independent_points / (independent_points - parameters_of_plane);
  const Eigen::Vector3d& variances = axes.values;
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

// Returns the support of each place. Computes the principal axes of many supports side
// by side, which is faster.
// \param[in] independent_points how many each support counts as
std::vector<Support>
supportsFrom (const PlaceMoments& moments, double independent_points, unsigned threads)
{
  // Chosen by hand, changes only the time.
  constexpr std::size_t supports_per_piece = 64;
  std::vector<Support> supports (moments.size());
  const auto computePiece = [&] (std::size_t begin, std::size_t end) {
    std::array<Eigen::Matrix3d, supports_per_piece> covariances;
    covariances.fill (Eigen::Matrix3d::Zero());
    std::array<PrincipalAxes, supports_per_piece> axes;
    for (std::size_t i = begin; i < end; ++i)
      covariances[i - begin] = moments[i].covariance();
    principalAxes (covariances.data(), end - begin, axes.data());
    for (std::size_t i = begin; i < end; ++i)
      supports[i] = supportOf (axes[i - begin], independent_points);
  };
  parallelFor (threads, moments.size(), supports_per_piece, computePiece);
  return supports;
}

// Returns for each place its moments plus those of its arms: the moments of the next
// level.
PlaceMoments
withArms (const PlaceMoments& moments,
          const Indices& arms,
          std::size_t arms_per_place,
          unsigned threads)
{
  PlaceMoments next_moments (moments);
  forEach (threads, moments.size(), [&] (std::size_t i) {
    for (std::size_t k = 0; k < arms_per_place; ++k)
      next_moments[i].addAligned (moments[arms[i * arms_per_place + k]]);
  });
  return next_moments;
}

// Returns the arms for level 1: the farthest of the nearest points of each place.
Indices
firstArms (const Places& places, std::size_t arms_per_place, unsigned threads)
{
  Indices arms (places.size() * arms_per_place);
  forEach (threads, places.size(), [&] (std::size_t i) {
    std::copy_n (places.nearestOf (i) + places.neighbors_per_place - arms_per_place,
                 arms_per_place,
                 arms.data() + i * arms_per_place);
  });
  return arms;
}

/** \brief The positions of the arms of a place [m], next to each other in memory:
 * looking up each one took a quarter of the time of the whole detection. If there are
 * fewer than eight arms, the last one is repeated. */
struct ArmPositions {
  static constexpr std::size_t size = place_constants.arms;
  static_assert ((size & (size - 1)) == 0, "farthestOf halves the list");
  std::array<float, size> x, y, z;
};

std::vector<ArmPositions>
positionsOf (const Coordinates& points,
             const Indices& arms,
             std::size_t arms_per_place,
             unsigned threads)
{
  std::vector<ArmPositions> positions (points.size());
  forEach (threads, points.size(), [&] (std::size_t i) {
    for (std::size_t k = 0; k < ArmPositions::size; ++k) {
      const std::uint32_t arm =
          arms[i * arms_per_place + std::min (k, arms_per_place - 1)];
      positions[i].x[k] = points.x[arm];
      positions[i].y[k] = points.y[arm];
      positions[i].z[k] = points.z[arm];
    }
  });
  return positions;
}

// Returns which of the arms is farthest from the position (x, y, z): its index in
// ArmPositions. In case of a tie the lowest index wins, so that it is never that of a
// repeated arm.
std::size_t
farthestOf (const ArmPositions& arms, float x, float y, float z)
{
  std::array<float, ArmPositions::size> squared_distances;
  for (std::size_t k = 0; k < ArmPositions::size; ++k) {
    const float dx = arms.x[k] - x;
    const float dy = arms.y[k] - y;
    const float dz = arms.z[k] - z;
    squared_distances[k] = dx * dx + dy * dy + dz * dz;
  }
  // Compute the maximum, largest[0], in a tree of pairs: in a sequential loop each
  // comparison would wait for the one before.
  std::array<float, ArmPositions::size> largest = squared_distances;
  for (std::size_t half = ArmPositions::size / 2; half > 0; half /= 2)
    for (std::size_t k = 0; k < half; ++k)
      largest[k] = std::max (largest[k], largest[k + half]);
  std::size_t farthest = 0;
  for (std::size_t k = ArmPositions::size; k-- > 0;)
    farthest = squared_distances[k] == largest[0] ? k : farthest;
  return farthest;
}

// Returns the arms of the next level: replaces each arm by that one of its own arms
// which is farthest from the place.
Indices
longerArms (const Coordinates& points,
            const Indices& arms,
            std::size_t arms_per_place,
            unsigned threads)
{
  const std::vector<ArmPositions> positions =
      positionsOf (points, arms, arms_per_place, threads);
  Indices longer (arms.size());
  forEach (threads, points.size(), [&] (std::size_t i) {
    for (std::size_t k = i * arms_per_place; k < (i + 1) * arms_per_place; ++k) {
      const std::size_t arm = arms[k];
      const std::size_t farthest =
          farthestOf (positions[arm], points.x[i], points.y[i], points.z[i]);
      longer[k] = arms[arm * arms_per_place + farthest];
    }
  });
  return longer;
}

// Returns how many independent points a support of each level counts as. Levels end
// where this would exceed max_share_of_points of all points; there are at least two.
std::vector<double>
pointsOfLevels (const Places& places)
{
  std::vector<double> points_of_level{
      static_cast<double> (places.neighbors_per_place + 1)};
  const double max_points =
      place_constants.max_share_of_points * static_cast<double> (places.size());
  const auto nextPoints = [&] {
    return points_of_level.back() * place_constants.points_per_level;
  };
  while (static_cast<int> (points_of_level.size()) < place_constants.max_levels &&
         (points_of_level.size() < 2 || nextPoints() <= max_points))
    points_of_level.push_back (nextPoints());
  return points_of_level;
}

// Returns the points with their depth levels moved closer together. The distance
// between levels is larger than that between points of one level: without the move, all
// nearest points of a place would be on its own level.
Coordinates
withNearerLevels (const Coordinates& points, const DepthLevels& levels)
{
  Coordinates nearer;
  nearer.resize (points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d point = points[i];
    const double depth = levels.direction.dot (point);
    const Eigen::Vector3f moved =
        (point - (1.0 - place_constants.depth_scale) * depth * levels.direction)
            .cast<float>();
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
  const std::size_t arms_per_place = armsPerPlace (places);
  places.points_of_level = pointsOfLevels (places);
  PlaceMoments moments = momentsOfNeighborhoods (places, threads);
  addQuantization (places, levels, threads, moments);
  Indices arms = firstArms (places, arms_per_place, threads); // those of level 1
  for (std::size_t level = 0; level < places.points_of_level.size(); ++level) {
    if (level > 1)
      arms = longerArms (points, arms, arms_per_place, threads);
    if (level > 0)
      moments = withArms (moments, arms, arms_per_place, threads);
    places.supports.push_back (
        supportsFrom (moments, places.points_of_level[level], threads));
  }
}

} // namespace

std::size_t
neighborhoodSize (double points, double factor)
{
  // Any three points lie on a plane, so the scatter of fewer than six points says
  // little about the noise.
  constexpr double min_size = 6.0;
  const double usual = place_constants.min_neighborhood *
                       std::pow (points / place_constants.points_of_min_neighborhood,
                                 place_constants.neighborhood_exponent);
  const double wanted =
      std::round (factor * std::clamp (usual,
                                       place_constants.min_neighborhood,
                                       place_constants.max_neighborhood));
  return static_cast<std::size_t> (
      std::clamp (wanted, min_size, static_cast<double> (NearestPoints::max_size)));
}

Places
describePlaces (const Coordinates& points,
                std::size_t neighborhood_size,
                unsigned threads)
{
  Places places;
  places.neighbors_per_place = neighborhood_size - 1;
  places.position.resize (points.size());
  forEach (
      threads, points.size(), [&] (std::size_t i) { places.position[i] = points[i]; });
  PointTree tree (points, threads);
  const DepthLevels levels = findDepthLevels (points, tree);
  if (!levels.step.empty())
    tree = PointTree (withNearerLevels (points, levels), threads);
  places.nearest = findAllNearest (tree, places.neighbors_per_place, threads);
  addSupports (points, levels, threads, places);
  places.density.resize (points.size());
  forEach (threads, points.size(), [&] (std::size_t i) {
    constexpr float least_area = 1e-30F; // [m^2], avoids a division by 0
    const float width = places.supports[0][i].width;
    places.density[i] =
        static_cast<float> (neighborhood_size) / (width * width + least_area);
  });
  return places;
}

} // namespace pcl_ops::internal
