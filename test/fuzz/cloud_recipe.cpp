// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>

#include "fuzz_targets.h"
#include "scene.h"

#include <cmath>
#include <limits>

namespace pcl_ops::fuzz {

namespace {

constexpr std::size_t max_points = 1200;
constexpr std::size_t max_points_of_a_shape = 400;

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

/** One shape: where, how large, how many points, and a seed for the rest. */
struct Shape {
  enum Kind {
    Plane,
    NoisyPlane,
    Line,
    Ball,
    Dust,
    EqualPoints,
    Lattice,
    AnyBits,
    FarPoint,
    NotFinite,
    LogUniform,
    PointsAgain,
    kinds
  };

  explicit Shape (ByteReader& bytes)
  : kind (static_cast<Kind> (bytes.below (kinds)))
  , count (1 + bytes.below (max_points_of_a_shape))
  , generator (bytes.take<std::uint16_t>())
  {
    for (int axis = 0; axis < 3; ++axis)
      place[axis] = 0.05 * bytes.take<std::int8_t>();
    size = 0.02 * (1 + bytes.take<std::uint8_t>());
    const double tilt = bytes.take<std::uint8_t>() * pi / 128.0;
    const double turn = bytes.take<std::uint8_t>() * pi / 128.0;
    frame = Eigen::AngleAxisd (turn, Eigen::Vector3d::UnitZ()) *
            Eigen::AngleAxisd (tilt, Eigen::Vector3d::UnitX());
  }

  double
  draw ()
  {
    return size * (2.0 * drawUnit (generator) - 1.0);
  }

  Eigen::Vector3d
  pointInItsFrame (std::size_t i)
  {
    switch (kind) {
    case Plane:
      return {draw(), draw(), 0.0};
    case NoisyPlane:
      return {draw(), draw(), 0.01 * draw()};
    case Line:
      return {draw(), 0.0, 0.0};
    case Ball:
      return size * Eigen::Vector3d (draw(), draw(), draw()).normalized();
    case Dust:
      return {draw(), draw(), draw()};
    case Lattice:
      return 0.1 * size * Eigen::Vector3d (i % 10, i / 10 % 10, i / 100);
    case LogUniform:
      return std::pow (10.0, 6.0 * draw()) * Eigen::Vector3d (draw(), draw(), draw());
    default:
      return Eigen::Vector3d::Zero();
    }
  }

  Kind kind;
  std::size_t count;
  RandomGenerator generator;
  Eigen::Vector3d place;
  double size;
  Eigen::Quaterniond frame;
};

void
addShape (ByteReader& bytes, Cloud& cloud)
{
  Shape shape (bytes);
  if (shape.kind == Shape::FarPoint)
    cloud.push_back (toPoint (std::pow (10.0, 38.0 * shape.size / 5.12) * shape.place));
  else if (shape.kind == Shape::NotFinite)
    cloud.push_back ({std::numeric_limits<float>::quiet_NaN(),
                      std::numeric_limits<float>::infinity(),
                      static_cast<float> (shape.size)});
  else if (shape.kind == Shape::AnyBits)
    for (std::size_t i = 0; i < shape.count && !bytes.isAtEnd(); ++i) {
      const float x = bytes.take<float>(), y = bytes.take<float>();
      cloud.push_back ({x, y, bytes.take<float>()});
    }
  else if (shape.kind == Shape::PointsAgain)
    for (std::size_t i = 0, size = cloud.size(); i < std::min (size, shape.count); ++i)
      cloud.push_back (cloud[i]);
  else
    for (std::size_t i = 0; i < shape.count; ++i)
      cloud.push_back (toPoint (shape.place + shape.frame * shape.pointInItsFrame (i)));
}

pcl::IndicesPtr
indicesFrom (ByteReader& bytes, std::size_t points)
{
  const std::size_t kind = bytes.below (16);
  RandomGenerator generator (bytes.take<std::uint16_t>());
  if (kind < 12)
    return nullptr;
  auto indices = pcl::make_shared<pcl::Indices>();
  for (std::size_t i = 0; i < points; ++i)
    if (kind != 12 || i % 3 == 0)
      indices->push_back (kind < 14
                              ? static_cast<pcl::index_t> (i)
                              : static_cast<pcl::index_t> (drawBelow (
                                    generator, static_cast<std::uint32_t> (points))));
  if (kind == 15)
    indices->push_back (static_cast<pcl::index_t> (generator()));
  return indices;
}

/** 1 for most bytes, else 1e-45 to 1e38. */
double
scaleFrom (ByteReader& bytes)
{
  const auto chosen = bytes.take<std::uint8_t>();
  return chosen < 168 ? 1.0 : std::pow (10.0, chosen - 168 - 45);
}

} // namespace

FuzzedCloud
cloudFrom (ByteReader& bytes)
{
  const double scale = scaleFrom (bytes);
  const double shift = bytes.take<std::uint8_t>() < 192
                           ? 0.0
                           : std::pow (10.0, bytes.take<std::uint8_t>() % 12);
  ByteReader before_shapes = bytes;
  bytes.take<std::uint32_t>();
  FuzzedCloud fuzzed{pcl::make_shared<Cloud>(), nullptr};
  while (!bytes.isAtEnd() && fuzzed.cloud->size() < max_points)
    addShape (bytes, *fuzzed.cloud);
  for (pcl::PointXYZ& point : *fuzzed.cloud)
    point.getVector3fMap() =
        (scale * point.getVector3fMap().cast<double>().array() + shift)
            .matrix()
            .cast<float>();
  fuzzed.indices = indicesFrom (before_shapes, fuzzed.cloud->size());
  return fuzzed;
}

} // namespace pcl_ops::fuzz
