// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kht/hough_planes.h"

#include "kht/spherical_accumulator.h"

#include <optional>
#include <queue>
#include <utility>

namespace pcl_ops::internal {
namespace {

// The rms distance of a cluster to its plane is at most this share of theta_h.
constexpr double largest_rms_share = 0.5;

// Fits of a plane, each to the clusters near the one before.
constexpr int fits_per_plane = 2;

double
weightOf (const Indices& clusters, const OctreeClusters& found)
{
  double weight = 0.0;
  for (const std::uint32_t cluster : clusters)
    weight += clusterWeight (found.clusters[cluster], found);
  return weight;
}

Moments
momentsOfClusters (const Indices& clusters, const OctreeClusters& found)
{
  Moments moments{found.root.center};
  for (const std::uint32_t cluster : clusters)
    moments += found.clusters[cluster].moments;
  return moments;
}

/** The clusters that no plane has yet and whose rms distance to one is small enough. */
Indices
freeNear (const Plane& plane,
          double largest_rms,
          const OctreeClusters& found,
          const std::vector<bool>& is_free)
{
  Indices near;
  for (std::uint32_t c = 0; c < is_free.size(); ++c)
    if (is_free[c] && meanSquaredDistance (found.clusters[c].moments, plane) <=
                          largest_rms * largest_rms)
      near.push_back (c);
  return near;
}

/** Planes by the weight they had when last looked at; of equal ones, by numbers below
 * zero, the first. Free clusters only become fewer. */
using Ranks = std::priority_queue<std::pair<double, std::ptrdiff_t>>;

Ranks
rankPlanes (const std::vector<HoughPlane>& planes, const OctreeClusters& found)
{
  Ranks ranks;
  for (std::size_t p = 0; p < planes.size(); ++p)
    ranks.emplace (weightOf (planes[p].clusters, found), -std::ptrdiff_t (p));
  return ranks;
}

} // namespace

double
clusterWeight (const CoplanarCluster& cluster, const OctreeClusters& found)
{
  constexpr double edge_weight = 0.75, count_weight = 0.25;
  const double count_share =
      static_cast<double> (cluster.size()) / static_cast<double> (found.points.size());
  return edge_weight * cluster.edge / found.root.edge + count_weight * count_share;
}

std::vector<HoughPlane>
voteForPlanes (const OctreeClusters& found, int phi_num, int rho_num)
{
  if (found.clusters.empty())
    return {};
  SphericalAccumulator accumulator (
      {BallDirections (phi_num), rho_num, found.root.radius / rho_num});
  const HoughSpace& space = accumulator.space;
  KernelVotes votes;
  for (std::uint32_t c = 0; c < found.clusters.size(); ++c) {
    const CoplanarCluster& cluster = found.clusters[c];
    const PlaneKernel kernel = planeKernel (cluster.fit,
                                            cluster.moments.covariance(),
                                            found.root.center,
                                            clusterWeight (cluster, found));
    castVotes (kernel, space, votes);
    accumulator.add (votes, c);
  }
  std::vector<HoughPlane> planes;
  for (HoughPeak& peak : accumulator.peaks()) {
    const Eigen::Vector3d normal = space.directions.vectorOf (peak.direction);
    const Eigen::Vector3d nearest = found.root.center + space.rhoOf (peak.bin) * normal;
    planes.push_back ({planeThrough (nearest, normal), std::move (peak.voters)});
  }
  std::vector<HoughPlane> sorted;
  for (auto ranks = rankPlanes (planes, found); !ranks.empty(); ranks.pop())
    sorted.push_back (std::move (planes[-ranks.top().second]));
  return sorted;
}

std::vector<HoughPlane>
refitPlanes (const std::vector<HoughPlane>& planes,
             const OctreeClusters& found,
             double min_share,
             double distance_threshold)
{
  const double min_count = min_share * static_cast<double> (found.points.size());
  std::vector<bool> is_free (found.clusters.size(), true);
  std::vector<HoughPlane> refitted;
  for (auto ranks = rankPlanes (planes, found); !ranks.empty();) {
    const auto [last_weight, rank] = ranks.top();
    ranks.pop();
    Indices clusters;
    for (const std::uint32_t cluster : planes[-rank].clusters)
      if (is_free[cluster])
        clusters.push_back (cluster);
    const double weight = weightOf (clusters, found);
    if (weight < last_weight) {
      ranks.emplace (weight, rank);
      continue;
    }
    Moments moments = momentsOfClusters (clusters, found);
    std::optional<PlaneFit> fit = fitPlane (moments);
    for (int i = 0; i < fits_per_plane && fit; ++i) {
      clusters =
          freeNear (fit->plane, largest_rms_share * distance_threshold, found, is_free);
      moments = momentsOfClusters (clusters, found);
      fit = fitPlane (moments);
    }
    if (!fit || moments.count < min_count)
      continue;
    for (const std::uint32_t cluster : clusters)
      is_free[cluster] = false;
    refitted.push_back ({fit->plane, std::move (clusters)});
  }
  return refitted;
}

} // namespace pcl_ops::internal
