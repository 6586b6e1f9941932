// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "changed_clouds.h"

#include <Eigen/Geometry>

#include <cmath>
#include <numeric>
#include <random>

namespace pcl_ops::evaluation {

namespace {

constexpr std::uint32_t seed_of_thinning = 1;
constexpr std::uint32_t seed_of_jitter = 2;

/** Its output is fixed by the C++ standard, that of std:: distributions is not. */
using RandomGenerator = std::mt19937;

/** Uniform, from [0, 1). */
double
drawUnit (RandomGenerator& generator)
{
  return generator() * (1.0 / 4294967296.0);
}

void
move (ChangedCloud& changed)
{
  const Eigen::Vector3f shift (0.0371f, 0.0613f, 0.0829f); // [m]; no round numbers
  for (pcl::PointXYZ& point : *changed.cloud)
    point.getVector3fMap() += shift;
  changed.cloud->sensor_origin_.head<3>() += shift;
}

void
turn (ChangedCloud& changed)
{
  constexpr double angle = 3.14159265358979323846 / 6.0; // [rad]
  const Eigen::Matrix3d rotation =
      Eigen::AngleAxisd (angle, Vector3d::UnitZ()).toRotationMatrix();
  const auto turned = [&rotation] (const Eigen::Vector3f& point) {
    return (rotation * point.cast<double>()).eval().cast<float>().eval();
  };
  for (pcl::PointXYZ& point : *changed.cloud)
    point.getVector3fMap() = turned (point.getVector3fMap());
  auto sensor = changed.cloud->sensor_origin_.head<3>();
  sensor = turned (sensor);
  changed.up = rotation * changed.up;
}

/** Exactly as many as are to go, each point with the same chance (Knuth, The Art of
 * Computer Programming 2, algorithm S). */
void
thin (ChangedCloud& changed)
{
  constexpr std::size_t one_in = 100;
  RandomGenerator generator (seed_of_thinning);
  XyzCloud& cloud = *changed.cloud;
  std::size_t kept = 0;
  std::size_t to_go = (cloud.size() + one_in - 1) / one_in;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (drawUnit (generator) * double (cloud.size() - i) < double (to_go))
      --to_go;
    else {
      cloud[kept] = cloud[i];
      changed.points[kept++] = changed.points[i];
    }
  cloud.resize (kept);
  changed.points.resize (kept);
}

void
jitter (ChangedCloud& changed)
{
  constexpr double most = 1e-4; // [m]
  RandomGenerator generator (seed_of_jitter);
  for (pcl::PointXYZ& point : *changed.cloud)
    for (float& coordinate : point.getVector3fMap())
      coordinate = float (coordinate + most * (2.0 * drawUnit (generator) - 1.0));
}

void
roundToMillimeters (ChangedCloud& changed)
{
  constexpr double per_meter = 1e3;
  for (pcl::PointXYZ& point : *changed.cloud)
    for (float& coordinate : point.getVector3fMap())
      coordinate = float (std::round (coordinate * per_meter) / per_meter);
}

} // namespace

const std::array<CloudChange, 5> cloud_changes{{{"moved", move},
                                                {"turned", turn},
                                                {"thinned", thin},
                                                {"jittered", jitter},
                                                {"rounded", roundToMillimeters}}};

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
