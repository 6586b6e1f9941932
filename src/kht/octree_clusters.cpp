// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kht/octree_clusters.h"

#include "base/parallel.h"
#include "search/counting_sort.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace pcl_ops::internal {
namespace {

// Points farther from a node's plane than this share of its edge are dropped.
constexpr double dropped_distance_share = 0.1;

// The nodes of this level, or of s_level if that is higher up, are shared out to
// threads.
constexpr int max_start_level = 2;

using OctantBegins = std::array<std::uint32_t, 9>;

/** Moments about the center of the root, so that those of nodes can be added. */
Moments
momentsOf (const Coordinates& points, const OctreeNode& node, const RootCube& root)
{
  Moments moments;
  moments.origin = root.center;
  for (std::uint32_t i = node.begin; i < node.end; ++i)
    moments.add (points.x[i] - root.center.x(),
                 points.y[i] - root.center.y(),
                 points.z[i] - root.center.z());
  return moments;
}

/** Moments of the deepest sorted leaves of a node. */
void
sumUpLeaves (const SortedOctree& octree,
             int level,
             std::size_t code,
             std::vector<Moments>& moments)
{
  const int shift = 3 * (octree.level - level);
  for (std::size_t leaf = code << shift; leaf < (code + 1) << shift; ++leaf)
    if (octree.begins[leaf] < octree.begins[leaf + 1])
      moments[leaf] =
          momentsOf (octree.points, octree.node (octree.level, leaf), octree.root);
}

/** Descends from a node and collects the clusters below, depth first. */
class ClusterCollector {
public:
  ClusterCollector (SortedOctree& octree,
                    const std::vector<Moments>& leaf_moments,
                    const OctreeClusterParameters& parameters,
                    std::vector<CoplanarCluster>& clusters)
  : octree_ (octree)
  , points_ (octree.points)
  , leaf_moments_ (leaf_moments)
  , parameters_ (parameters)
  , clusters_ (clusters)
  {}

  /** Through the levels that are sorted, down to those that are not. */
  void
  descendSorted (int level, std::size_t code)
  {
    const OctreeNode node = octree_.node (level, code);
    if (node.size() < parameters_.min_samples)
      return;
    if (level == octree_.level)
      return descend (node, leaf_moments_[code]);
    if (level >= parameters_.first_level &&
        addIfCoplanar (node, sumOfLeaves (level, code)))
      return;
    for (std::size_t octant = 0; octant < 8; ++octant)
      descendSorted (level + 1, 8 * code + octant);
  }

private:
  void
  descend (const OctreeNode& node, const Moments& moments)
  {
    if (node.level >= parameters_.first_level && addIfCoplanar (node, moments))
      return;
    if (node.level >= parameters_.max_level)
      return;
    const OctantBegins begins = sortIntoOctants (node);
    const double quarter = node.edge / 4.0;
    for (unsigned octant = 0; octant < 8; ++octant) {
      const Eigen::Vector3d offset (octant & 1u ? quarter : -quarter,
                                    octant & 2u ? quarter : -quarter,
                                    octant & 4u ? quarter : -quarter);
      const OctreeNode child{begins[octant],
                             begins[octant + 1],
                             node.center + offset,
                             node.edge / 2.0,
                             node.level + 1};
      if (child.size() >= parameters_.min_samples)
        descend (child, momentsOf (points_, child, octree_.root));
    }
  }

  Moments
  sumOfLeaves (int level, std::size_t code) const
  {
    const int shift = 3 * (octree_.level - level);
    Moments sum;
    for (std::size_t leaf = code << shift; leaf < (code + 1) << shift; ++leaf)
      sum += leaf_moments_[leaf];
    return sum;
  }

  bool
  addIfCoplanar (const OctreeNode& node, const Moments& moments)
  {
    std::optional<PlaneFit> fit = fitPlane (moments);
    if (!fit || !isCoplanar (fit->variances))
      return false;
    CoplanarCluster cluster;
    cluster.moments = moments;
    OctreeNode kept = node;
    kept.end = dropFarPoints (node, fit->plane);
    if (kept.end < node.end) {
      cluster.moments = momentsOf (points_, kept, octree_.root);
      fit = fitPlane (cluster.moments);
    }
    if (!fit)
      return true;
    cluster.fit = *fit;
    cluster.edge = node.edge;
    cluster.level = node.level;
    cluster.begin = kept.begin;
    cluster.end = kept.end;
    clusters_.push_back (cluster);
    return true;
  }

  bool
  isCoplanar (const Eigen::Vector3d& variances) const
  {
    return variances[0] * parameters_.s_alpha < variances[1] &&
           variances[1] * parameters_.s_beta > variances[2];
  }

  /** Moves the points near the plane to the node's front; returns their end. */
  std::uint32_t
  dropFarPoints (const OctreeNode& node, const Plane& plane)
  {
    const double most = dropped_distance_share * node.edge;
    std::uint32_t end = node.begin;
    for (std::uint32_t i = node.begin; i < node.end; ++i)
      if (std::abs (plane.distance (points_[i])) <= most)
        points_.swapPoints (end++, i);
    return end;
  }

  /** A stable counting sort of the node's points. */
  OctantBegins
  sortIntoOctants (const OctreeNode& node)
  {
    const std::size_t size = node.size();
    const Eigen::Vector3f center = node.center.cast<float>();
    octants_.resize (size);
    sorted_.resize (size);
    for (std::size_t i = 0; i < size; ++i)
      octants_[i] = octantOf (node.begin + i, center);
    OctantBegins begins;
    findBegins (octants_, begins);
    forPlaces (octants_, begins, [&] (std::size_t i, std::uint32_t place) {
      sorted_.copyFrom (points_, node.begin + i, place);
    });
    for (std::size_t i = 0; i < size; ++i)
      points_.copyFrom (sorted_, i, node.begin + i);
    for (std::uint32_t& begin : begins)
      begin += node.begin;
    return begins;
  }

  std::uint8_t
  octantOf (std::size_t i, const Eigen::Vector3f& center) const
  {
    return static_cast<std::uint8_t> ((points_.x[i] >= center.x() ? 1u : 0u) |
                                      (points_.y[i] >= center.y() ? 2u : 0u) |
                                      (points_.z[i] >= center.z() ? 4u : 0u));
  }

  SortedOctree& octree_;
  PermutedPoints& points_;
  const std::vector<Moments>& leaf_moments_;
  const OctreeClusterParameters& parameters_;
  std::vector<CoplanarCluster>& clusters_;
  PermutedPoints sorted_;
  std::vector<std::uint8_t> octants_;
};

} // namespace

OctreeClusters
findCoplanarClusters (const Coordinates& points,
                      const OctreeClusterParameters& parameters,
                      unsigned threads)
{
  OctreeClusters result;
  result.root = rootCubeOf (points);
  if (!(result.root.edge > 0.0))
    return result;
  SortedOctree octree = sortIntoOctree (points, result.root, deepest_sorted_level);
  std::vector<Moments> leaf_moments (octree.begins.size() - 1);
  const int start_level = std::clamp (parameters.first_level, 0, max_start_level);
  const std::size_t starts = std::size_t (1) << (3 * start_level);
  std::vector<std::vector<CoplanarCluster>> found (starts);
  parallelFor (threads, starts, 1, [&] (std::size_t begin, std::size_t end) {
    for (std::size_t code = begin; code < end; ++code) {
      sumUpLeaves (octree, start_level, code, leaf_moments);
      ClusterCollector collector (octree, leaf_moments, parameters, found[code]);
      collector.descendSorted (start_level, code);
    }
  });
  for (const std::vector<CoplanarCluster>& clusters : found)
    result.clusters.insert (result.clusters.end(), clusters.begin(), clusters.end());
  result.points = std::move (octree.points);
  return result;
}

} // namespace pcl_ops::internal
