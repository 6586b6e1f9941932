// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "paper/hough_planes.h"

#include "paper/spherical_accumulator.h"

#include <optional>
#include <queue>
#include <utility>

namespace pcl_ops::internal {
namespace {

// Largest rms distance of a cluster to its plane, in units of theta_h. The paper has no
// refit: this number and the next one were chosen by hand.
constexpr double max_rms_by_theta_h = 0.5;

// How many times a plane is fitted to the clusters near its previous fit.
constexpr int fits_per_plane = 2;

double
weightOfClusters (const Indices& clusters, const OctreeClusters& octree)
{
  double weight = 0.0;
  for (const std::uint32_t cluster : clusters)
    weight += clusterWeight (octree.clusters[cluster], octree);
  return weight;
}

Moments
momentsOfClusters (const Indices& clusters, const OctreeClusters& octree)
{
  Moments moments{octree.root.center};
  for (const std::uint32_t cluster : clusters)
    moments += octree.clusters[cluster].moments;
  return moments;
}

/** Returns the free clusters whose points have an rms distance of at most max_rms [m]
 * to a plane. */
Indices
freeClustersNear (const Plane& plane,
                  double max_rms,
                  const OctreeClusters& octree,
                  const std::vector<bool>& is_free)
{
  Indices near;
  for (std::uint32_t c = 0; c < is_free.size(); ++c)
    if (is_free[c] &&
        meanSquaredDistance (octree.clusters[c].moments, plane) <= max_rms * max_rms)
      near.push_back (c);
  return near;
}

/** A plane and the weight of its free clusters when this weight was last computed: an
 * upper bound of the present weight, as planes only lose free clusters. */
struct RankedPlane {
  double weight = 0.0;
  std::size_t index = 0; // in the list of planes

  /** By weight; of planes of equal weight the one with the lower index ranks higher. */
  bool
  operator<(const RankedPlane& other) const
  {
    if (weight != other.weight)
      return weight < other.weight;
    return index > other.index;
  }
};

/** The plane with the largest weight is on top. */
using Ranks = std::priority_queue<RankedPlane>;

Ranks
rankPlanes (const std::vector<HoughPlane>& planes, const OctreeClusters& octree)
{
  Ranks ranks;
  for (std::size_t index = 0; index < planes.size(); ++index)
    ranks.push ({weightOfClusters (planes[index].clusters, octree), index});
  return ranks;
}

/** Fits a plane to free clusters, then fits_per_plane times to the free clusters near
 * it, and takes those of the last fit.
 * \param[in] clusters to begin with, all free
 * \param[in] max_rms of a cluster near the plane [m]
 * \param[in,out] is_free false for clusters that a plane has taken
 * \return the plane and its clusters; nothing if they span no plane or have fewer than
 * min_count points */
std::optional<HoughPlane>
takeClusters (Indices clusters,
              const OctreeClusters& octree,
              double min_count,
              double max_rms,
              std::vector<bool>& is_free)
{
  Moments moments = momentsOfClusters (clusters, octree);
  std::optional<PlaneFit> fit = fitPlane (moments);
  for (int i = 0; i < fits_per_plane && fit; ++i) {
    clusters = freeClustersNear (fit->plane, max_rms, octree, is_free);
    moments = momentsOfClusters (clusters, octree);
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
clusterWeight (const CoplanarCluster& cluster, const OctreeClusters& octree)
{
  // As published.
  constexpr double edge_weight = 0.75;
  constexpr double count_weight = 0.25;
  const double share_of_points =
      static_cast<double> (cluster.size()) / static_cast<double> (octree.points.size());
  return edge_weight * cluster.edge / octree.root.edge + count_weight * share_of_points;
}

std::vector<HoughPlane>
voteForPlanes (const OctreeClusters& octree, int phi_num, int rho_num)
{
  if (octree.clusters.empty())
    return {};
  SphericalAccumulator accumulator (
      {BallDirections (phi_num), rho_num, octree.root.radius / rho_num});
  const HoughSpace& space = accumulator.space;
  KernelVotes votes;
  for (std::uint32_t c = 0; c < octree.clusters.size(); ++c) {
    const CoplanarCluster& cluster = octree.clusters[c];
    const PlaneKernel kernel = planeKernel (cluster.fit,
                                            cluster.moments.covariance(),
                                            octree.root.center,
                                            clusterWeight (cluster, octree));
    castVotes (kernel, space, votes);
    accumulator.add (votes, c);
  }
  std::vector<HoughPlane> planes;
  for (HoughPeak& peak : accumulator.peaks()) {
    const Eigen::Vector3d normal = space.directions.vectorOf (peak.direction);
    const Eigen::Vector3d on_plane =
        octree.root.center + space.rhoOf (peak.bin) * normal;
    planes.push_back ({planeThrough (on_plane, normal), std::move (peak.voters)});
  }
  std::vector<HoughPlane> sorted;
  Ranks ranks = rankPlanes (planes, octree);
  while (!ranks.empty()) {
    sorted.push_back (std::move (planes[ranks.top().index]));
    ranks.pop();
  }
  return sorted;
}

std::vector<HoughPlane>
refitPlanes (const std::vector<HoughPlane>& planes,
             const OctreeClusters& octree,
             double min_share,
             double distance_threshold)
{
  const double min_count = min_share * static_cast<double> (octree.points.size());
  std::vector<bool> is_free (octree.clusters.size(), true);
  std::vector<HoughPlane> refitted;
  Ranks ranks = rankPlanes (planes, octree);
  while (!ranks.empty()) {
    const RankedPlane next = ranks.top();
    ranks.pop();
    Indices clusters;
    for (const std::uint32_t cluster : planes[next.index].clusters)
      if (is_free[cluster])
        clusters.push_back (cluster);
    const double weight = weightOfClusters (clusters, octree);
    // Other planes have taken clusters since this plane was ranked.
    const bool is_outdated = weight < next.weight;
    if (is_outdated) {
      ranks.push ({weight, next.index});
      continue;
    }
    std::optional<HoughPlane> plane =
        takeClusters (std::move (clusters),
                      octree,
                      min_count,
                      max_rms_by_theta_h * distance_threshold,
                      is_free);
    if (plane)
      refitted.push_back (std::move (*plane));
  }
  return refitted;
}

} // namespace pcl_ops::internal
