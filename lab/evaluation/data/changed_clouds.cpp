// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "changed_clouds.h"

#include <pcl/common/io.h>

#include <Eigen/Geometry>

#include <cmath>
#include <numeric>
#include <random>

namespace pcl_ops::evaluation {

namespace {

constexpr std::uint32_t seed_of_points = 1;
constexpr std::uint32_t seed_of_jitter = 2;

/** The C++ standard fixes the output of this generator, but not that of std::
 * distributions, which are therefore not used. */
using RandomGenerator = std::mt19937;

/** Draws a number from 0, included, to 1, excluded, with uniform probability. */
double
drawUnit (RandomGenerator& generator)
{
  constexpr double range = 4294967296.0; // 2^32
  return generator() * (1.0 / range);
}

void
move (ChangedCloud& changed)
{
  // Not multiples of a usual voxel size, so that voxels begin elsewhere in the cloud
  // [m].
  const Eigen::Vector3f shift (0.0371f, 0.0613f, 0.0829f);
  for (pcl::PointXYZ& point : *changed.cloud)
    point.getVector3fMap() += shift;
  changed.cloud->sensor_origin_.head<3>() += shift;
}

void
turn (ChangedCloud& changed)
{
  constexpr double angle = 3.14159265358979323846 / 6.0; // 30 degrees [rad]
  const Eigen::Matrix3d rotation =
      Eigen::AngleAxisd (angle, Vector3d::UnitZ()).toRotationMatrix();
  const auto turned = [&rotation] (const Eigen::Vector3f& point) {
    return (rotation * point.cast<double>()).eval().cast<float>().eval();
  };
  for (pcl::PointXYZ& point : *changed.cloud)
    point.getVector3fMap() = turned (point.getVector3fMap());
  auto sensor = changed.cloud->sensor_origin_.head<3>();
  sensor = turned (sensor);
  changed.cloud->sensor_orientation_ =
      Eigen::Quaterniond (rotation).cast<float>() * changed.cloud->sensor_orientation_;
  changed.up = rotation * changed.up;
}

void
thin (ChangedCloud& changed)
{
  constexpr std::size_t points_per_removed_point = 100;
  const std::size_t all = changed.points.size();
  const std::size_t removed =
      (all + points_per_removed_point - 1) / points_per_removed_point; // rounded up
  changed.points = drawIndices (all, all - removed);
  const XyzCloud before = *changed.cloud;
  pcl::copyPointCloud (before, changed.points, *changed.cloud);
}

void
jitter (ChangedCloud& changed)
{
  constexpr double largest_shift = 1e-4; // [m]
  RandomGenerator generator (seed_of_jitter);
  for (pcl::PointXYZ& point : *changed.cloud)
    for (float& coordinate : point.getVector3fMap())
      coordinate =
          float (coordinate + largest_shift * (2.0 * drawUnit (generator) - 1.0));
}

void
roundToMillimeters (ChangedCloud& changed)
{
  constexpr double millimeters_per_meter = 1e3;
  for (pcl::PointXYZ& point : *changed.cloud)
    for (float& coordinate : point.getVector3fMap())
      coordinate = float (std::round (coordinate * millimeters_per_meter) /
                          millimeters_per_meter);
}

} // namespace

const std::array<CloudChange, 5> cloud_changes{{{"moved", move},
                                                {"turned", turn},
                                                {"thinned", thin},
                                                {"jittered", jitter},
                                                {"rounded", roundToMillimeters}}};

pcl::Indices
drawIndices (std::size_t size, std::size_t count)
{
  RandomGenerator generator (seed_of_points);
  pcl::Indices points;
  points.reserve (count);
  for (std::size_t i = 0; i < size; ++i)
    if (drawUnit (generator) * double (size - i) < double (count - points.size()))
      points.push_back (pcl::index_t (i));
  return points;
}

ChangedCloud
changedCloud (const XyzCloud& cloud, const Vector3d& up, const CloudChange& change)
{
  ChangedCloud changed{XyzCloud::Ptr (new XyzCloud (cloud)), up, {}};
  changed.points.resize (cloud.size());
  std::iota (changed.points.begin(), changed.points.end(), 0);
  change.apply (changed);
  return changed;
}

} // namespace pcl_ops::evaluation
