// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_ops/octree_clusters.h>
#include <pcl_ops/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace pcl_ops {
namespace {

// Points farther from a node's plane than this share of its edge are dropped.
constexpr double dropped_distance_share = 0.1;

constexpr std::size_t cells_per_piece = 256;

using OctantBegins = std::array<std::uint32_t, 9>;

Moments
momentsOf (const Coordinates& points,
           std::uint32_t begin,
           std::uint32_t end,
           const Eigen::Vector3d& origin)
{
  Moments moments;
  moments.origin = origin;
  for (std::uint32_t i = begin; i < end; ++i)
    moments.add (
        points.x[i] - origin.x(), points.y[i] - origin.y(), points.z[i] - origin.z());
  return moments;
}

/** Descends from a cell and collects the clusters below, depth first. */
class ClusterCollector {
public:
  ClusterCollector (PermutedPoints& points,
                    const OctreeClusterParameters& parameters,
                    std::vector<CoplanarCluster>& clusters)
  : points_ (points), parameters_ (parameters), clusters_ (clusters)
  {}

  void
  descend (const OctreeNode& node)
  {
    if (node.size() < parameters_.min_samples)
      return;
    if (node.level >= parameters_.first_level && addIfCoplanar (node))
      return;
    if (node.level >= parameters_.deepest_level)
      return;
    const OctantBegins begins = sortIntoOctants (node);
    const double quarter = node.edge / 4.0;
    for (unsigned octant = 0; octant < 8; ++octant) {
      const Eigen::Vector3d offset (octant & 1u ? quarter : -quarter,
                                    octant & 2u ? quarter : -quarter,
                                    octant & 4u ? quarter : -quarter);
      descend (OctreeNode{begins[octant],
                          begins[octant + 1],
                          node.centre + offset,
                          node.edge / 2.0,
                          node.level + 1});
    }
  }

private:
  bool
  addIfCoplanar (const OctreeNode& node)
  {
    CoplanarCluster cluster;
    cluster.moments = momentsOf (points_, node.begin, node.end, node.centre);
    std::optional<PlaneFit> fit = fitPlane (cluster.moments);
    if (!fit || !isCoplanar (fit->variances))
      return false;
    cluster.begin = node.begin;
    cluster.end = dropFarPoints (node, fit->plane);
    if (cluster.end < node.end) {
      cluster.moments = momentsOf (points_, cluster.begin, cluster.end, node.centre);
      fit = fitPlane (cluster.moments);
    }
    if (!fit)
      return true;
    cluster.fit = *fit;
    cluster.edge = node.edge;
    cluster.level = node.level;
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
    const Eigen::Vector3f centre = node.centre.cast<float>();
    octants_.resize (size);
    sorted_.resize (size);
    OctantBegins begins{};
    for (std::size_t i = 0; i < size; ++i) {
      octants_[i] = octantOf (node.begin + i, centre);
      ++begins[octants_[i] + 1u];
    }
    for (std::size_t octant = 0; octant < 8; ++octant)
      begins[octant + 1] += begins[octant];
    OctantBegins next = begins;
    for (std::size_t i = 0; i < size; ++i)
      sorted_.copyFrom (points_, node.begin + i, next[octants_[i]]++);
    for (std::size_t i = 0; i < size; ++i)
      points_.copyFrom (sorted_, i, node.begin + i);
    for (std::uint32_t& begin : begins)
      begin += node.begin;
    return begins;
  }

  std::uint8_t
  octantOf (std::size_t i, const Eigen::Vector3f& centre) const
  {
    return static_cast<std::uint8_t> ((points_.x[i] >= centre.x() ? 1u : 0u) |
                                      (points_.y[i] >= centre.y() ? 2u : 0u) |
                                      (points_.z[i] >= centre.z() ? 4u : 0u));
  }

  PermutedPoints& points_;
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
  const int level = std::clamp (parameters.first_level, 0, deepest_cell_level);
  OctreeCells cells = sortIntoCells (points, result.root, level);
  std::vector<std::vector<CoplanarCluster>> found (cells.size() / cells_per_piece + 1);
  const auto search_cells = [&] (std::size_t begin, std::size_t end) {
    ClusterCollector collector (
        cells.points, parameters, found[begin / cells_per_piece]);
    for (std::size_t cell = begin; cell < end; ++cell)
      collector.descend (cells[cell]);
  };
  parallelFor (threads, cells.size(), cells_per_piece, search_cells);
  for (const std::vector<CoplanarCluster>& clusters : found)
    result.clusters.insert (result.clusters.end(), clusters.begin(), clusters.end());
  result.points = std::move (cells.points);
  return result;
}

} // namespace pcl_ops
