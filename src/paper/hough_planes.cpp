// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "paper/hough_planes.h"

#include "paper/spherical_accumulator.h"

#include <optional>
#include <queue>
#include <utility>

namespace pcl_ops::internal {
namespace {

// The rms distance of a cluster to its plane is at most this share of theta_h.
constexpr double largest_rms_share = 0.5;

// How often a plane is fitted to the clusters near its previous fit.
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

/** The free clusters whose rms distance to a plane is at most largest_rms [m]. */
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

/** A plane and its weight when it was last computed: an upper bound of its weight now,
 * as it only loses free clusters. */
struct RankedPlane {
  double weight = 0.0;
  std::size_t plane = 0;

  /** Of planes of equal weight the one with the lower index is the larger one. */
  bool
  operator<(const RankedPlane& other) const
  {
    if (weight != other.weight)
      return weight < other.weight;
    return plane > other.plane;
  }
};

/** The plane with the largest weight is on top. */
using Ranks = std::priority_queue<RankedPlane>;

Ranks
rankPlanes (const std::vector<HoughPlane>& planes, const OctreeClusters& found)
{
  Ranks ranks;
  for (std::size_t plane = 0; plane < planes.size(); ++plane)
    ranks.push ({weightOf (planes[plane].clusters, found), plane});
  return ranks;
}

/** Fits a plane to free clusters, then to the free clusters near it, and takes these.
 * \param[in,out] is_free false for clusters that a plane has taken
 * \return the plane and its clusters; nothing if they span no plane or have fewer than
 * min_count points */
std::optional<HoughPlane>
takeClusters (Indices clusters,
              const OctreeClusters& found,
              double min_count,
              double largest_rms,
              std::vector<bool>& is_free)
{
  Moments moments = momentsOfClusters (clusters, found);
  std::optional<PlaneFit> fit = fitPlane (moments);
  for (int i = 0; i < fits_per_plane && fit; ++i) {
    clusters = freeNear (fit->plane, largest_rms, found, is_free);
    moments = momentsOfClusters (clusters, found);
    fit = fitPlane (moments);
  }
  if (!fit || moments.count < min_count)
    return std::nullopt;
  for (const std::uint32_t cluster : clusters)
    is_free[cluster] = false;
  return HoughPlane{fit->plane, std::move (clusters)};
}

} // namespace

double
clusterWeight (const CoplanarCluster& cluster, const OctreeClusters& found)
{
  constexpr double edge_weight = 0.75;
  constexpr double count_weight = 0.25;
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
  Ranks ranks = rankPlanes (planes, found);
  while (!ranks.empty()) {
    sorted.push_back (std::move (planes[ranks.top().plane]));
    ranks.pop();
  }
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
  Ranks ranks = rankPlanes (planes, found);
  while (!ranks.empty()) {
    const RankedPlane next = ranks.top();
    ranks.pop();
    Indices clusters;
    for (const std::uint32_t cluster : planes[next.plane].clusters)
      if (is_free[cluster])
        clusters.push_back (cluster);
    const double weight = weightOf (clusters, found);
    if (weight < next.weight) {
      ranks.push ({weight, next.plane});
      continue;
    }
    std::optional<HoughPlane> plane =
        takeClusters (std::move (clusters),
                      found,
                      min_count,
                      largest_rms_share * distance_threshold,
                      is_free);
    if (plane)
      refitted.push_back (std::move (*plane));
  }
  return refitted;
}

} // namespace pcl_ops::internal
