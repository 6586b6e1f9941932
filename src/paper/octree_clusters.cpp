// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "paper/octree_clusters.h"

#include <Eigen/Geometry>

#include "base/parallel.h"
#include "cloud/morton_code.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

namespace pcl_ops::internal {
namespace {

// A root cube with an edge [m] below this counts as a single point: from this edge on,
// the number of cubes per meter is finite in single precision down to level 20, the
// default of max_level.
constexpr double min_edge = 1e-30;

// Points farther from a node's plane than this share of its edge are dropped, as
// published.
constexpr double dropped_distance_share = 0.1;

// All points are sorted into the nodes of this level in one pass: the codes of its 8^5
// nodes fit into 16 bits, their counters into the second level cache.
constexpr int sorted_level = 5;

// The threads share the nodes of this level, or of s_level (first_level) if that is
// nearer to the root: of up to 64 nodes.
constexpr int max_start_level = 2;

struct Range {
  double low = 0.0, high = 0.0;
};

/** Returns the range of the values without the 2 percent at either end, which may be
 * outliers. Of two values low is the larger one.
 * \param[in,out] values one at least; reordered */
Range
rangeWithoutStrays (std::vector<float>& values)
{
  constexpr double stray_share = 0.02; // chosen by hand
  const double last = static_cast<double> (values.size() - 1);
  const auto stray = static_cast<std::ptrdiff_t> (std::ceil (stray_share * last));
  const auto low = values.begin() + stray;
  const auto high = values.end() - 1 - stray;
  std::nth_element (values.begin(), low, values.end());
  const double lowest = *low;
  std::nth_element (values.begin(), high, values.end());
  return {lowest, *high};
}

/** Returns the box of the points that are not outliers: the ranges of \ref
 * rangeWithoutStrays, extended at both ends by the width of the widest range. */
Eigen::AlignedBox3d
boxWithoutOutliers (const Coordinates& points)
{
  // A sample by the order of the points could miss the surface of every other point.
  constexpr std::size_t max_sample = 10000; // about; chosen by hand
  Coordinates sample = samplePoints (points, max_sample);
  if (sample.size() == 0) // of equal points the sample has all or none
    sample = points;
  const Range x = rangeWithoutStrays (sample.x);
  const Range y = rangeWithoutStrays (sample.y);
  const Range z = rangeWithoutStrays (sample.z);
  const Eigen::Vector3d low (x.low, y.low, z.low);
  const Eigen::Vector3d high (x.high, y.high, z.high);
  const double spread = (high - low).maxCoeff();
  // If nearly all points are equal, or there are only two, no point is an outlier.
  const double width = spread > 0.0 ? spread : std::numeric_limits<double>::infinity();
  return {low - Eigen::Vector3d::Constant (width),
          high + Eigen::Vector3d::Constant (width)};
}

/** A node of the octree: a cube and the points in it. */
struct OctreeNode {
  /** Its points: the range [begin, end) of OctreeClusters::points. */
  std::uint32_t begin = 0, end = 0;
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  /** Length of its edge [m]. */
  double edge = 0.0;
  /** 0 for the root. */
  int level = 0;
  /** Morton code among the nodes of its level; 0 at levels deeper than sorted_level,
   * which do not use it. */
  std::size_t code = 0;

  std::size_t
  size () const
  {
    return end - begin;
  }
};

/** Sorts a node's points into the 8^levels cubes that it is divided into, in Morton
 * order (a stable counting sort).
 * \param[in] pointAt pointAt (i) is point i of the node
 * \param[out] sorted the points of the root; those of the node are overwritten
 * \return index in \p sorted of each cube's first point, then the end of the last
 * cube */
template <typename PointAt>
Indices
sortIntoCubes (const OctreeNode& node,
               int levels,
               PointAt&& pointAt,
               OctreePoint* sorted)
{
  const int cubes_per_axis = 1 << levels;
  const auto scale = static_cast<float> (cubes_per_axis / node.edge); // [cubes/m]
  const auto half = 0.5f * static_cast<float> (cubes_per_axis);
  const auto last = static_cast<float> (cubes_per_axis - 1);
  const Eigen::Vector3f center = node.center.cast<float>();
  const auto bitsOfCube = [=] (float coordinate, float center_of_node) {
    // A point in the middle of a cube so small that scale is infinite gives NaN, which
    // std::max in this argument order turns into 0.
    const float cube =
        std::min (last, std::max (0.0f, (coordinate - center_of_node) * scale + half));
    return spreadBits (static_cast<std::uint32_t> (cube));
  };
  std::vector<std::uint16_t> codes (node.size());
  Indices begins ((std::size_t (1) << (3 * levels)) + 1, 0);
  for (std::size_t i = 0; i < codes.size(); ++i) {
    const OctreePoint p = pointAt (i);
    codes[i] = static_cast<std::uint16_t> (bitsOfCube (p.x, center.x()) |
                                           bitsOfCube (p.y, center.y()) << 1 |
                                           bitsOfCube (p.z, center.z()) << 2);
    ++begins[codes[i] + std::size_t (1)];
  }
  begins[0] = node.begin;
  std::partial_sum (begins.begin(), begins.end(), begins.begin());
  Indices next = begins;
  for (std::size_t i = 0; i < codes.size(); ++i)
    sorted[next[codes[i]]++] = pointAt (i);
  return begins;
}

/** Visits a node and those that it is divided into, depth first, and collects the
 * clusters. */
struct Descent {
  const RootCube& root;
  /** Index of the first point of each node of sorted_level, then the end of the last
   * node. */
  const Indices& begins;
  const OctreeClusterParameters& parameters;
  std::vector<OctreePoint>& points;
  std::vector<CoplanarCluster> clusters = {};

  /** A node of a level from the root down to sorted_level. */
  OctreeNode
  sortedNode (int level, std::size_t code) const
  {
    const double edge = std::ldexp (root.edge, -level);
    // The codes of these nodes are made of the numbers of cubes along each axis,
    // without the key_offset of voxels: so this key has just these numbers.
    const VoxelKey cube = shiftedKeyOf (code);
    // In units of the node's edge.
    const Eigen::Vector3d from_corner (cube.x + 0.5, cube.y + 0.5, cube.z + 0.5);
    const Eigen::Vector3d half_root = Eigen::Vector3d::Constant (root.edge / 2.0);
    // Each level between adds three bits to the codes.
    const int shift = 3 * (sorted_level - level);
    return {begins[code << shift],
            begins[(code + 1) << shift],
            root.center - half_root + edge * from_corner,
            edge,
            level,
            code};
  }

  /** Adds the cluster of a node, or those of the nodes below it. */
  void
  descend (const OctreeNode& node)
  {
    if (node.size() < parameters.min_samples)
      return;
    if (node.level >= parameters.first_level && addIfCoplanar (node))
      return;
    if (node.level >= parameters.max_level)
      return;
    if (node.level < sorted_level) {
      for (std::size_t octant = 0; octant < 8; ++octant)
        descend (sortedNode (node.level + 1, 8 * node.code + octant));
      return;
    }
    const std::vector<OctreePoint> unsorted (points.begin() + node.begin,
                                             points.begin() + node.end);
    const Indices octants = sortIntoCubes (
        node, 1, [&] (std::size_t i) { return unsorted[i]; }, points.data());
    const double quarter = node.edge / 4.0;
    for (unsigned octant = 0; octant < 8; ++octant) {
      const Eigen::Vector3d offset (octant & 1u ? quarter : -quarter,
                                    octant & 2u ? quarter : -quarter,
                                    octant & 4u ? quarter : -quarter);
      descend ({octants[octant],
                octants[octant + 1],
                node.center + offset,
                node.edge / 2.0,
                node.level + 1});
    }
  }

private:
  /** \return whether the points of the node are coplanar. They make no cluster if those
   * near their plane span no plane. */
  bool
  addIfCoplanar (const OctreeNode& node)
  {
    CoplanarCluster cluster{{}, {}, node.edge, node.level, node.begin, node.end};
    std::optional<PlaneFit> fit = fitTo (cluster);
    if (!fit || !isCoplanar (fit->variances))
      return false;
    cluster.end = dropFarPoints (node, fit->plane);
    if (cluster.end < node.end)
      fit = fitTo (cluster);
    if (!fit)
      return true;
    cluster.fit = *fit;
    clusters.push_back (cluster);
    return true;
  }

  /** Measures a cluster's moments and fits a plane. The moments are about the center of
   * the root, so that moments of several clusters can be added. */
  std::optional<PlaneFit>
  fitTo (CoplanarCluster& cluster) const
  {
    const Eigen::Vector3d center = root.center;
    Moments moments{center}; // a local variable, which stays in registers
    for (std::uint32_t i = cluster.begin; i < cluster.end; ++i)
      moments.add (
          points[i].x - center.x(), points[i].y - center.y(), points[i].z - center.z());
    cluster.moments = moments;
    return fitPlane (cluster.moments);
  }

  bool
  isCoplanar (const Eigen::Vector3d& variances) const
  {
    return variances[0] * parameters.s_alpha < variances[1] &&
           variances[1] * parameters.s_beta > variances[2];
  }

  /** Moves the points near the plane to the front of the node's range.
   * \return the end of these points */
  std::uint32_t
  dropFarPoints (const OctreeNode& node, const Plane& plane)
  {
    const double max_distance = dropped_distance_share * node.edge;
    std::uint32_t end = node.begin;
    for (std::uint32_t i = node.begin; i < node.end; ++i)
      if (std::abs (plane.distance (points[i].position())) <= max_distance)
        std::swap (points[end++], points[i]);
    return end;
  }
};

/** Sets \ref OctreeClusters::points.
 * \return index of the first point of each node of sorted_level, then the end of the
 * last node */
Indices
sortPoints (const Coordinates& points, OctreeClusters& result)
{
  Indices order (points.size());
  std::iota (order.begin(), order.end(), 0);
  const auto outside =
      std::stable_partition (order.begin(), order.end(), [&] (std::uint32_t i) {
        return result.root.holds (points[i]);
      });
  const OctreeNode root{0,
                        static_cast<std::uint32_t> (outside - order.begin()),
                        result.root.center,
                        result.root.edge};
  const auto pointAt = [&] (std::size_t i) {
    const std::uint32_t p = order[i];
    return OctreePoint{points.x[p], points.y[p], points.z[p], p};
  };
  result.points.resize (points.size());
  for (std::size_t i = root.end; i < points.size(); ++i)
    result.points[i] = pointAt (i);
  return sortIntoCubes (root, sorted_level, pointAt, result.points.data());
}

} // namespace

RootCube
rootCubeOf (const Coordinates& points)
{
  RootCube root;
  if (points.size() == 0)
    return root;
  const Eigen::AlignedBox3d box_without_outliers = boxWithoutOutliers (points);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::AlignedBox3d box;
  std::size_t count = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (const Eigen::Vector3d point = points[i];
        box_without_outliers.contains (point)) {
      sum += point;
      box.extend (point);
      ++count;
    }
  root.center = sum / static_cast<double> (count);
  const double edge =
      2.0 * (box.max() - root.center).cwiseMax (root.center - box.min()).maxCoeff();
  root.edge = box.max() == box.min() || edge < min_edge ? 0.0 : edge;
  double squared_radius = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (const Eigen::Vector3d point = points[i]; root.holds (point))
      squared_radius = std::max (squared_radius, (point - root.center).squaredNorm());
  root.radius = std::sqrt (squared_radius);
  return root;
}

OctreeClusters
findCoplanarClusters (const Coordinates& points,
                      const OctreeClusterParameters& parameters,
                      unsigned threads)
{
  OctreeClusters result;
  result.root = rootCubeOf (points);
  if (!(result.root.edge > 0.0))
    return result;
  const Indices begins = sortPoints (points, result);
  const int start_level = std::clamp (parameters.first_level, 0, max_start_level);
  const std::size_t start_nodes = std::size_t (1) << (3 * start_level);
  constexpr std::size_t nodes_per_piece = 1;
  const auto clusters_of_nodes =
      parallelPieces (threads,
                      start_nodes,
                      nodes_per_piece,
                      [&] (std::size_t code, std::size_t /*end*/) {
                        Descent descent{result.root, begins, parameters, result.points};
                        descent.descend (descent.sortedNode (start_level, code));
                        return std::move (descent.clusters);
                      });
  for (const std::vector<CoplanarCluster>& clusters : clusters_of_nodes)
    result.clusters.insert (result.clusters.end(), clusters.begin(), clusters.end());
  return result;
}

} // namespace pcl_ops::internal
