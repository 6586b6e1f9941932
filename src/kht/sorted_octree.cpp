// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kht/sorted_octree.h"

#include <Eigen/Geometry>

#include "search/counting_sort.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace pcl_ops::internal {
namespace {

// Cubes below it are points: their leaves could not be counted in single precision [m].
constexpr double smallest_edge = 1e-30;

// How many points tell where the others are.
constexpr std::size_t looked_at = 10000;

// Points beyond this share of all, at either end of a coordinate, may be stray ones.
constexpr double stray_share = 0.02;

/** Where all points are that are not far from the others. */
struct Fence {
  Eigen::Vector3d low, high;

  bool
  holds (const Eigen::Vector3d& point) const
  {
    return (point.array() >= low.array()).all() &&
           (point.array() <= high.array()).all();
  }
};

/** From where to where values are, stray ones left out; some of them stand for all. */
std::pair<double, double>
middleOf (const std::vector<float>& values)
{
  const std::size_t stride = values.size() / looked_at + 1;
  std::vector<float> some;
  for (std::size_t i = 0; i < values.size(); i += stride)
    some.push_back (values[i]);
  const auto stray =
      static_cast<std::ptrdiff_t> (std::ceil (stray_share * (some.size() - 1)));
  const auto low = some.begin() + stray, high = some.end() - 1 - stray;
  std::nth_element (some.begin(), low, some.end());
  const double lowest = *low;
  std::nth_element (some.begin(), high, some.end());
  return {lowest, *high};
}

Fence
fenceOf (const Coordinates& points)
{
  Fence fence;
  Eigen::Index axis = 0;
  for (const auto* values : {&points.x, &points.y, &points.z}) {
    std::tie (fence.low[axis], fence.high[axis]) = middleOf (*values);
    ++axis;
  }
  double width = (fence.high - fence.low).maxCoeff();
  // Where nearly all points are equal nothing tells how far the others may be.
  if (!(width > 0.0))
    width = std::numeric_limits<double>::infinity();
  fence.low.array() -= width;
  fence.high.array() += width;
  return fence;
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

/** Points outside the cube get the code after that of the last leaf. */
std::vector<std::uint16_t>
mortonCodes (const Coordinates& points, const RootCube& root, int level)
{
  const auto spread = spreadBits();
  const int leaves = 1 << level;
  const auto scale = static_cast<float> (leaves / root.edge);
  const Eigen::Vector3f center = root.center.cast<float>();
  const auto half = static_cast<float> (leaves / 2.0);
  const auto last = static_cast<float> (leaves - 1);
  const auto leaf = [last, scale, half] (float value, float middle) {
    return static_cast<int> (std::clamp ((value - middle) * scale + half, 0.0f, last));
  };
  const auto outside = static_cast<std::uint16_t> (1 << (3 * level));
  std::vector<std::uint16_t> codes (points.size(), outside);
  for (std::size_t i = 0; i < codes.size(); ++i)
    if (root.holds (points[i]))
      codes[i] =
          static_cast<std::uint16_t> (spread[leaf (points.x[i], center.x())] |
                                      (spread[leaf (points.y[i], center.y())] << 1) |
                                      (spread[leaf (points.z[i], center.z())] << 2));
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
  const Fence fence = fenceOf (points);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::AlignedBox3d box;
  std::size_t count = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (const Eigen::Vector3d point = points[i]; fence.holds (point)) {
      sum += point;
      box.extend (point);
      ++count;
    }
  root.center = sum / static_cast<double> (count);
  const double edge =
      2.0 * (box.max() - root.center).cwiseMax (root.center - box.min()).maxCoeff();
  root.edge = box.max() == box.min() || edge < smallest_edge ? 0.0 : edge;
  double squared_radius = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (const Eigen::Vector3d point = points[i]; root.holds (point))
      squared_radius = std::max (squared_radius, (point - root.center).squaredNorm());
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
  const Eigen::Vector3d center = root.center - half_root + edge * from_corner;
  const int shift = 3 * (level - node_level);
  return OctreeNode{
      begins[code << shift], begins[(code + 1) << shift], center, edge, node_level};
}

SortedOctree
sortIntoOctree (const Coordinates& points, const RootCube& root, int level)
{
  const std::vector<std::uint16_t> codes = mortonCodes (points, root, level);
  const std::size_t leaves = std::size_t (1) << (3 * level);
  std::vector<std::uint32_t> begins (leaves + 2);
  findBegins (codes, begins);
  PermutedPoints sorted;
  sorted.resize (points.size());
  forPlaces (codes, begins, [&] (std::size_t i, std::uint32_t place) {
    sorted.x[place] = points.x[i];
    sorted.y[place] = points.y[i];
    sorted.z[place] = points.z[i];
    sorted.order[place] = static_cast<std::uint32_t> (i);
  });
  begins.pop_back();
  return SortedOctree{root, level, std::move (sorted), std::move (begins)};
}

} // namespace pcl_ops::internal
