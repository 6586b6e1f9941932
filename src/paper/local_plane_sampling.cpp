// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "paper/local_plane_sampling.h"

#include <Eigen/Geometry>

#include "cloud/voxel_grid.h"
#include "cloud/voxel_size.h"
#include "geometry/float_plane.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <utility>

namespace pcl_ops::internal {
namespace {

/** \brief Finds the points within a fixed radius of one of them. The points are sorted
 * into voxels whose edge is that radius, or longer if most voxels would be nearly
 * empty. Sorting takes a fraction of the time of building a k-d tree. */
struct FixedRadiusSearch {
  float squared_radius;
  VoxelNeighbors neighbors_of_voxel;
  /** \brief Index of each voxel's first point, then the number of points. */
  Indices voxel_begin;
  /** \brief All points, voxel by voxel. */
  Coordinates points;

  FixedRadiusSearch (const Coordinates& positions, double radius, unsigned threads)
  : squared_radius (static_cast<float> (radius * radius))
  {
    // Visiting a voxel takes time even if it is nearly empty. The number was chosen by
    // hand; the order of the points, and so the random draws, depend on it.
    constexpr double min_points_per_voxel = 16.0;
    const double max_voxels =
        std::max (1.0, static_cast<double> (positions.size()) / min_points_per_voxel);
    const double edge = std::max (radius, voxelSizeFor (positions, max_voxels));
    VoxelGrid grid = voxelize (positions, edge, threads);
    connect (grid, threads);
    neighbors_of_voxel = std::move (grid.neighbors);
    voxel_begin = std::move (grid.first_point);
    voxel_begin.push_back (static_cast<std::uint32_t> (positions.size()));
    points = selected (positions, *grid.order);
  }

  /** \brief Finds the points within the radius of a point, as a \ref SphereFinder.
   * \param[out] sphere indices of the points within the radius
   * \return how many points were examined */
  std::size_t
  find (std::uint32_t point, Indices& sphere) const
  {
    const float x = points.x[point];
    const float y = points.y[point];
    const float z = points.z[point];
    const auto next_voxel =
        std::upper_bound (voxel_begin.begin(), voxel_begin.end(), point);
    const auto own_voxel =
        static_cast<std::size_t> (next_voxel - voxel_begin.begin()) - 1;
    std::size_t found = 0;
    std::size_t examined = 0;
    for (const std::uint32_t neighbor : neighbors_of_voxel[own_voxel]) {
      const std::uint32_t begin = voxel_begin[neighbor];
      const std::uint32_t end = voxel_begin[neighbor + 1];
      examined += end - begin;
      sphere.resize (found + (end - begin));
      for (std::uint32_t i = begin; i < end; ++i) {
        const float dx = points.x[i] - x;
        const float dy = points.y[i] - y;
        const float dz = points.z[i] - z;
        // Each point is written, and overwritten by the next one if it is not near. A
        // branch instead would often be mispredicted.
        sphere[found] = i;
        found += dx * dx + dy * dy + dz * dz <= squared_radius;
      }
    }
    sphere.resize (found);
    return examined;
  }
};

/** Number of points drawn for a hypothesis before it is given up; chosen by hand. */
constexpr int max_draws = 1000;

std::uint32_t
drawFrom (const Indices& indices, RandomGenerator& generator)
{
  const auto size = static_cast<std::uint32_t> (indices.size());
  return indices[drawBelow (generator, size)];
}

/** Draws hypotheses in spheres and tests them. */
struct PlaneSampler {
  const Coordinates& points;
  const LocalSamplingParameters& parameters;
  float threshold; // theta_h [m]
  RandomGenerator generator;

  /** Moments of the inliers of a hypothesis, if it passes the local test: more than
   * alpha_min N_loc of N_loc points drawn from the sphere are inliers. The test ends as
   * soon as it must fail or, with Inliers::Sphere, as soon as it is passed. */
  std::optional<Moments>
  inliersOf (const FloatPlane& plane, const Indices& sphere)
  {
    const auto isInlier = [&] (std::uint32_t i) {
      return plane.distance (points.x[i], points.y[i], points.z[i]) < threshold;
    };
    const bool counts_sphere =
        parameters.inliers == LocalSamplingParameters::Inliers::Sphere;
    const double needed = parameters.min_inlier_fraction * parameters.local_samples;
    Indices samples;
    unsigned inliers = 0;
    for (unsigned to_draw = parameters.local_samples; to_draw > 0;) {
      samples.push_back (drawFrom (sphere, generator));
      inliers += isInlier (samples.back()) ? 1 : 0;
      --to_draw;
      if (inliers + to_draw <= needed)
        return std::nullopt;
      if (inliers > needed && counts_sphere)
        break;
    }
    Moments moments;
    for (const std::uint32_t i : counts_sphere ? sphere : samples)
      if (isInlier (i))
        moments.add (points.x[i], points.y[i], points.z[i]);
    return moments;
  }

  /** One turn of the paper's loop: moments of the inliers of a plane through p_r0, the
   * point origin, if there is one.
   * \param[in,out] visits max_draws are added if the draws give no hypothesis */
  std::optional<Moments>
  inliersAround (std::uint32_t origin, const Indices& sphere, double& visits)
  {
    if (sphere.size() < parameters.local_samples)
      return std::nullopt;
    const std::optional<Plane> plane =
        drawHypothesis (points, origin, sphere, parameters.inner_radius, generator);
    if (!plane) {
      visits += max_draws;
      return std::nullopt;
    }
    return inliersOf (FloatPlane (*plane), sphere);
  }
};

} // namespace

Spheres
spheresAround (const DetectorInput& input,
               const Points& points,
               double radius,
               unsigned threads)
{
  if (input.search_over && points.size() > 0) {
    // For each point of the cloud its index in points; none for points that are not
    // used.
    constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    Indices index_in_points (input.cloud.size, none);
    for (std::size_t i = 0; i < points.size(); ++i)
      index_in_points[points.indexOf (i)] = static_cast<std::uint32_t> (i);
    return {
        points,
        [&points,
         radius,
         search = input.search_over (points.index),
         index_in_points = std::move (index_in_points)] (std::uint32_t center,
                                                         Indices& sphere) {
          pcl::Indices neighbors;
          std::vector<float> squared_distances;
          search.within (points.indexOf (center), radius, neighbors, squared_distances);
          sphere.clear();
          for (const pcl::index_t neighbor : neighbors)
            if (const std::uint32_t index = index_in_points[neighbor]; index != none)
              sphere.push_back (index);
          return sphere.size();
        }};
  }
  const auto search =
      std::make_shared<const FixedRadiusSearch> (points, radius, threads);
  return {search->points, [search] (std::uint32_t center, Indices& sphere) {
            return search->find (center, sphere);
          }};
}

std::optional<Plane>
drawHypothesis (const Coordinates& points,
                std::uint32_t origin,
                const Indices& sphere,
                double inner_radius,
                RandomGenerator& generator)
{
  // Three points count as a line if the sine of their angle at p_r0 is at most this;
  // chosen by hand.
  constexpr double min_sine = 1e-3;
  const Eigen::Vector3d p0 = points[origin];
  // From p_r0 to p_r1; 0 until p_r1 is drawn.
  Eigen::Vector3d first_edge = Eigen::Vector3d::Zero();
  for (int draw = 0; draw < max_draws; ++draw) {
    const Eigen::Vector3d edge = points[drawFrom (sphere, generator)] - p0;
    if (edge.isZero (0.0) || edge.squaredNorm() > inner_radius * inner_radius)
      continue;
    const Eigen::Vector3d cross = first_edge.cross (edge);
    if (cross.norm() > min_sine * first_edge.norm() * edge.norm())
      return planeThrough (p0, cross.normalized());
    first_edge = first_edge.isZero (0.0) ? edge : Eigen::Vector3d::Zero();
  }
  return std::nullopt;
}

LocalPlanes
sampleLocalPlanes (const Coordinates& points,
                   const SphereFinder& find_sphere,
                   const LocalSamplingParameters& parameters,
                   double distance_threshold,
                   std::uint32_t seed)
{
  const auto size = static_cast<std::uint32_t> (points.size());
  const double max_inliers = parameters.max_inliers_per_point * size;       // N_max
  const double max_hypotheses = parameters.max_hypotheses_per_point * size; // K_max
  const double max_visits = parameters.max_visits_per_point * size;
  // On a surface a search examines three times as many points as the sphere holds: nine
  // voxels of edge r2 have the area 9 r2^2, the sphere cuts out pi r2^2. In noise it
  // examines more.
  constexpr double examined_per_point_in_sphere = 3.0;
  // An empty sphere takes time, too: about so many visits, chosen by hand.
  constexpr double visits_per_sphere = 100.0;
  double inliers_of_all = 0.0; // n
  double hypotheses = 0.0;     // k
  double visits = 0.0;
  PlaneSampler sampler{points,
                       parameters,
                       static_cast<float> (distance_threshold),
                       RandomGenerator (seed)};
  LocalPlanes found;
  Indices sphere;
  while (inliers_of_all < max_inliers && hypotheses < max_hypotheses &&
         visits < max_visits) {
    ++hypotheses;
    const std::uint32_t origin = drawBelow (sampler.generator, size);
    const auto examined = static_cast<double> (find_sphere (origin, sphere));
    visits += visits_per_sphere + std::max (static_cast<double> (sphere.size()),
                                            examined / examined_per_point_in_sphere);
    const std::optional<Moments> inliers =
        sampler.inliersAround (origin, sphere, visits);
    if (!inliers)
      continue;
    inliers_of_all += inliers->count;
    found.moments.push_back (*inliers);
  }
  found.hypotheses = static_cast<std::size_t> (hypotheses);
  return found;
}

} // namespace pcl_ops::internal
