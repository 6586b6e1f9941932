// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kht/sorted_octree.h"

#include "search/counting_sort.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace pcl_ops::internal {
namespace {

// Cubes below it are points: their leaves could not be counted in single precision [m].
constexpr double smallest_edge = 1e-30;

struct AxisRange {
  float low = std::numeric_limits<float>::infinity();
  float high = -std::numeric_limits<float>::infinity();
  double mean = 0.0;

  /** Largest |value - mean|. */
  double
  reach () const
  {
    return std::max (high - mean, mean - low);
  }
};

AxisRange
rangeOf (const std::vector<float>& values)
{
  AxisRange range;
  double sum = 0.0;
  for (const float value : values) {
    range.low = std::min (range.low, value);
    range.high = std::max (range.high, value);
    sum += value;
  }
  range.mean = sum / static_cast<double> (values.size());
  return range;
}

/** The bits of a leaf's coordinate moved three places apart. */
std::array<std::uint16_t, 1 << deepest_sorted_level>
spreadBits ()
{
  std::array<std::uint16_t, 1 << deepest_sorted_level> spread{};
  for (unsigned value = 0; value < spread.size(); ++value)
    for (unsigned bit = 0; bit < deepest_sorted_level; ++bit)
      spread[value] |= static_cast<std::uint16_t> (((value >> bit) & 1u) << (3 * bit));
  return spread;
}

/** The inverse of spreadBits for one axis of a Morton code. */
unsigned
gatherBits (std::size_t code, unsigned axis)
{
  unsigned value = 0;
  for (unsigned bit = 0; bit < deepest_sorted_level; ++bit)
    value |= static_cast<unsigned> ((code >> (3 * bit + axis)) & 1u) << bit;
  return value;
}

std::vector<std::uint16_t>
mortonCodes (const Coordinates& points, const RootCube& root, int level)
{
  const auto spread = spreadBits();
  const int leaves = 1 << level;
  const auto scale = static_cast<float> (leaves / root.edge);
  const Eigen::Vector3f centre = root.centre.cast<float>();
  const auto half = static_cast<float> (leaves / 2.0);
  const auto last = static_cast<float> (leaves - 1);
  const auto leaf = [last, scale, half] (float value, float middle) {
    return static_cast<int> (std::clamp ((value - middle) * scale + half, 0.0f, last));
  };
  std::vector<std::uint16_t> codes (points.size());
  for (std::size_t i = 0; i < codes.size(); ++i)
    codes[i] =
        static_cast<std::uint16_t> (spread[leaf (points.x[i], centre.x())] |
                                    (spread[leaf (points.y[i], centre.y())] << 1) |
                                    (spread[leaf (points.z[i], centre.z())] << 2));
  return codes;
}

} // namespace

void
PermutedPoints::resize (std::size_t size)
{
  x.resize (size);
  y.resize (size);
  z.resize (size);
  order.resize (size);
}

void
PermutedPoints::swapPoints (std::size_t i, std::size_t j)
{
  std::swap (x[i], x[j]);
  std::swap (y[i], y[j]);
  std::swap (z[i], z[j]);
  std::swap (order[i], order[j]);
}

RootCube
rootCubeOf (const Coordinates& points)
{
  RootCube root;
  if (points.size() == 0)
    return root;
  const AxisRange x = rangeOf (points.x), y = rangeOf (points.y),
                  z = rangeOf (points.z);
  root.centre = Eigen::Vector3d (x.mean, y.mean, z.mean);
  const double edge = 2.0 * std::max ({x.reach(), y.reach(), z.reach()});
  const bool all_equal = x.low == x.high && y.low == y.high && z.low == z.high;
  root.edge = all_equal || edge < smallest_edge ? 0.0 : edge;
  double squared_radius = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double dx = points.x[i] - x.mean;
    const double dy = points.y[i] - y.mean;
    const double dz = points.z[i] - z.mean;
    squared_radius = std::max (squared_radius, dx * dx + dy * dy + dz * dz);
  }
  root.radius = std::sqrt (squared_radius);
  return root;
}

OctreeNode
SortedOctree::node (int node_level, std::size_t code) const
{
  const double edge = std::ldexp (root.edge, -node_level);
  const Eigen::Vector3d from_corner (gatherBits (code, 0) + 0.5,
                                     gatherBits (code, 1) + 0.5,
                                     gatherBits (code, 2) + 0.5);
  const Eigen::Vector3d half_root = Eigen::Vector3d::Constant (root.edge / 2.0);
  const Eigen::Vector3d centre = root.centre - half_root + edge * from_corner;
  const int shift = 3 * (level - node_level);
  return OctreeNode{
      begins[code << shift], begins[(code + 1) << shift], centre, edge, node_level};
}

SortedOctree
sortIntoOctree (const Coordinates& points, const RootCube& root, int level)
{
  const std::vector<std::uint16_t> codes = mortonCodes (points, root, level);
  const std::size_t leaves = std::size_t (1) << (3 * level);
  std::vector<std::uint32_t> begins (leaves + 1);
  findBegins (codes, begins);
  PermutedPoints sorted;
  sorted.resize (points.size());
  forPlaces (codes, begins, [&] (std::size_t i, std::uint32_t place) {
    sorted.x[place] = points.x[i];
    sorted.y[place] = points.y[i];
    sorted.z[place] = points.z[i];
    sorted.order[place] = static_cast<std::uint32_t> (i);
  });
  return SortedOctree{root, level, std::move (sorted), std::move (begins)};
}

} // namespace pcl_ops::internal
