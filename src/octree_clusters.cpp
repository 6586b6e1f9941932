// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_ops/octree_clusters.h>
#include <pcl_ops/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pcl_ops {
namespace {

/** Levels sorted at once, by Morton code: 8^5 cells fit a 16 bit code and the cache. */
constexpr int most_sorted_levels = 5;

/** Cells of the sorted levels a thread takes at a time. */
constexpr std::size_t cells_per_piece = 256;

/** Points farther from a node's plane than this share of its edge are dropped. */
constexpr double dropped_distance_share = 0.1;

struct Node {
  std::uint32_t begin, end;
  Eigen::Vector3d centre;
  double edge;
  int level;

  std::size_t
  size () const
  {
    return end - begin;
  }
};

/** Positions with the index each had in the cloud; nodes are ranges of it. */
struct PermutedPoints : Coordinates {
  Positions order;

  void
  resize (std::size_t size)
  {
    x.resize (size);
    y.resize (size);
    z.resize (size);
    order.resize (size);
  }

  void
  set (std::size_t i, const PermutedPoints& other, std::size_t j)
  {
    x[i] = other.x[j];
    y[i] = other.y[j];
    z[i] = other.z[j];
    order[i] = other.order[j];
  }

  void
  swap (std::size_t i, std::size_t j)
  {
    std::swap (x[i], x[j]);
    std::swap (y[i], y[j]);
    std::swap (z[i], z[j]);
    std::swap (order[i], order[j]);
  }
};

struct Range {
  float low = std::numeric_limits<float>::infinity ();
  float high = -std::numeric_limits<float>::infinity ();
  double sum = 0.0;

  double
  mean (std::size_t count) const
  {
    return sum / static_cast<double> (count);
  }

  /** Largest |value - mean|. */
  double
  reach (std::size_t count) const
  {
    return std::max (high - mean (count), mean (count) - low);
  }
};

Range
rangeOf (const std::vector<float>& values)
{
  Range range;
  for (const float value : values) {
    range.low = std::min (range.low, value);
    range.high = std::max (range.high, value);
    range.sum += value;
  }
  return range;
}

/** The root cube; no points, no cube. */
OctreeClusters
boundPoints (const Coordinates& points)
{
  OctreeClusters bounds;
  if (points.size () == 0)
    return bounds;
  const std::size_t count = points.size ();
  const Range x = rangeOf (points.x), y = rangeOf (points.y), z = rangeOf (points.z);
  bounds.centre = Eigen::Vector3d (x.mean (count), y.mean (count), z.mean (count));
  bounds.root_edge =
      2.0 * std::max ({x.reach (count), y.reach (count), z.reach (count)});
  const Eigen::Vector3f centre = bounds.centre.cast<float> ();
  float squared_radius = 0.0f;
  for (std::size_t i = 0; i < count; ++i) {
    const float dx = points.x[i] - centre.x ();
    const float dy = points.y[i] - centre.y ();
    const float dz = points.z[i] - centre.z ();
    squared_radius = std::max (squared_radius, dx * dx + dy * dy + dz * dz);
  }
  bounds.radius = std::sqrt (squared_radius);
  return bounds;
}

/** The bits of a cell coordinate moved three places apart. */
std::array<std::uint16_t, 1 << most_sorted_levels>
spreadBits ()
{
  std::array<std::uint16_t, 1 << most_sorted_levels> spread{};
  for (unsigned value = 0; value < spread.size (); ++value)
    for (unsigned bit = 0; bit < most_sorted_levels; ++bit)
      spread[value] |= static_cast<std::uint16_t> (((value >> bit) & 1u) << (3 * bit));
  return spread;
}

/** The inverse of spreadBits for one axis of a Morton code. */
unsigned
gatherBits (unsigned code, unsigned axis)
{
  unsigned value = 0;
  for (unsigned bit = 0; bit < most_sorted_levels; ++bit)
    value |= ((code >> (3 * bit + axis)) & 1u) << bit;
  return value;
}

/** Morton code of each point's cell after some levels of the octree. */
std::vector<std::uint16_t>
mortonCodes (const Coordinates& points, const OctreeClusters& bounds, int levels)
{
  const auto spread = spreadBits ();
  const int cells = 1 << levels;
  const auto scale = static_cast<float> (cells / bounds.root_edge);
  const Eigen::Vector3d corner =
      bounds.centre - Eigen::Vector3d::Constant (bounds.root_edge / 2.0);
  const Eigen::Vector3f zero = corner.cast<float> ();
  const auto cell = [cells, scale] (float value, float low) {
    return std::clamp (static_cast<int> ((value - low) * scale), 0, cells - 1);
  };
  std::vector<std::uint16_t> codes (points.size ());
  for (std::size_t i = 0; i < codes.size (); ++i)
    codes[i] = static_cast<std::uint16_t> (
        spread[cell (points.x[i], zero.x ())] |
        (spread[cell (points.y[i], zero.y ())] << 1) |
        (spread[cell (points.z[i], zero.z ())] << 2));
  return codes;
}

/** Moves the points into the order of their codes (a stable counting sort).
 * \return where each cell begins, and the end */
std::vector<std::uint32_t>
sortByCode (const Coordinates& points,
            const std::vector<std::uint16_t>& codes,
            std::size_t cells,
            PermutedPoints& sorted)
{
  std::vector<std::uint32_t> begins (cells + 1, 0);
  for (const std::uint16_t code : codes)
    ++begins[code + 1];
  for (std::size_t cell = 0; cell < cells; ++cell)
    begins[cell + 1] += begins[cell];
  std::vector<std::uint32_t> next (begins.begin (), begins.end () - 1);
  sorted.resize (points.size ());
  for (std::size_t i = 0; i < codes.size (); ++i) {
    const std::uint32_t to = next[codes[i]]++;
    sorted.x[to] = points.x[i];
    sorted.y[to] = points.y[i];
    sorted.z[to] = points.z[i];
    sorted.order[to] = static_cast<std::uint32_t> (i);
  }
  return begins;
}

Moments
momentsOfRange (const Coordinates& points,
                std::uint32_t begin,
                std::uint32_t end,
                const Eigen::Vector3d& origin)
{
  Moments moments;
  moments.origin = origin;
  for (std::uint32_t i = begin; i < end; ++i)
    moments.add (points.x[i] - origin.x (),
                 points.y[i] - origin.y (),
                 points.z[i] - origin.z ());
  return moments;
}

/** Descends below the sorted levels and collects the clusters, depth first. */
class ClusterCollector {
public:
  ClusterCollector (PermutedPoints& points,
                    const OctreeClusterParameters& parameters,
                    std::vector<CoplanarCluster>& clusters)
  : points_ (points), parameters_ (parameters), clusters_ (clusters)
  {}

  void
  descend (const Node& node)
  {
    if (node.size () < parameters_.min_samples)
      return;
    if (node.level >= parameters_.first_level && addIfCoplanar (node))
      return;
    if (node.level >= parameters_.deepest_level)
      return;
    const std::array<std::uint32_t, 9> begins = sortIntoOctants (node);
    const double quarter = node.edge / 4.0;
    for (unsigned octant = 0; octant < 8; ++octant) {
      const Eigen::Vector3d offset (octant & 1u ? quarter : -quarter,
                                    octant & 2u ? quarter : -quarter,
                                    octant & 4u ? quarter : -quarter);
      descend (Node{begins[octant],
                    begins[octant + 1],
                    node.centre + offset,
                    node.edge / 2.0,
                    node.level + 1});
    }
  }

private:
  bool
  addIfCoplanar (const Node& node)
  {
    CoplanarCluster cluster;
    cluster.moments = momentsOfRange (points_, node.begin, node.end, node.centre);
    std::optional<PlaneFit> fit = fitPlane (cluster.moments);
    if (!fit || !isCoplanar (fit->variances))
      return false;
    cluster.begin = node.begin;
    cluster.end = dropFarPoints (node, fit->plane);
    if (cluster.end < node.end) {
      cluster.moments =
          momentsOfRange (points_, cluster.begin, cluster.end, node.centre);
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
  dropFarPoints (const Node& node, const Plane& plane)
  {
    const double most = dropped_distance_share * node.edge;
    std::uint32_t end = node.begin;
    for (std::uint32_t i = node.begin; i < node.end; ++i)
      if (std::abs (plane.distance (points_[i])) <= most)
        points_.swap (end++, i);
    return end;
  }

  std::array<std::uint32_t, 9>
  sortIntoOctants (const Node& node)
  {
    const Eigen::Vector3f centre = node.centre.cast<float> ();
    octants_.resize (node.size ());
    sorted_.resize (node.size ());
    std::array<std::uint32_t, 9> begins{};
    for (std::size_t i = 0; i < octants_.size (); ++i) {
      const std::size_t from = node.begin + i;
      octants_[i] = static_cast<std::uint8_t> (
          (points_.x[from] >= centre.x () ? 1u : 0u) |
          (points_.y[from] >= centre.y () ? 2u : 0u) |
          (points_.z[from] >= centre.z () ? 4u : 0u));
      ++begins[octants_[i] + 1u];
    }
    for (std::size_t octant = 0; octant < 8; ++octant)
      begins[octant + 1] += begins[octant];
    std::array<std::uint32_t, 9> next = begins;
    for (std::size_t i = 0; i < octants_.size (); ++i)
      sorted_.set (next[octants_[i]]++, points_, node.begin + i);
    for (std::size_t i = 0; i < octants_.size (); ++i)
      points_.set (node.begin + i, sorted_, i);
    for (std::uint32_t& begin : begins)
      begin += node.begin;
    return begins;
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
  OctreeClusters result = boundPoints (points);
  if (!(result.root_edge > 0.0))
    return result;
  const int levels = std::clamp (parameters.first_level, 0, most_sorted_levels);
  const std::size_t cells = std::size_t (1) << (3 * levels);
  PermutedPoints sorted;
  const std::vector<std::uint32_t> begins =
      sortByCode (points, mortonCodes (points, result, levels), cells, sorted);

  const double edge = std::ldexp (result.root_edge, -levels);
  const Eigen::Vector3d first_centre =
      result.centre - Eigen::Vector3d::Constant ((result.root_edge - edge) / 2.0);
  std::vector<std::vector<CoplanarCluster>> found (cells / cells_per_piece + 1);
  parallelFor (
      threads, cells, cells_per_piece, [&] (std::size_t first, std::size_t last) {
        ClusterCollector collector (sorted, parameters, found[first / cells_per_piece]);
        for (auto cell = static_cast<unsigned> (first); cell < last; ++cell) {
          const Eigen::Vector3d position (
              gatherBits (cell, 0), gatherBits (cell, 1), gatherBits (cell, 2));
          collector.descend (Node{begins[cell],
                                  begins[cell + 1],
                                  first_centre + edge * position,
                                  edge,
                                  levels});
        }
      });
  for (const std::vector<CoplanarCluster>& piece : found)
    result.clusters.insert (result.clusters.end (), piece.begin (), piece.end ());
  result.order = std::move (sorted.order);
  return result;
}

} // namespace pcl_ops
