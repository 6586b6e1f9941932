// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <detection/known_sensor.h>
#include <pcl_ops/buildings/plane_kinds.h>
#include <pcl_ops/detect_planes.h>
#include <pcl_ops/oriented_point_sampling.h>
#include <support/lidar_scans.h>

using Eigen::Vector3d;
using namespace pcl_ops;
using namespace pcl_ops::apps;

namespace {

/** \brief A floor of 4 m by 4 m below zero, and half of it a second time, lower. */
ShiftedCloud
floorBelow (const Vector3d& sensor, bool has_cellar)
{
  ShiftedCloud shifted{XyzCloud::Ptr (new XyzCloud)};
  for (float x = -2.0f; x < 2.0f; x += 0.02f)
    for (float y = -2.0f; y < 2.0f; y += 0.02f) {
      shifted.cloud->emplace_back (x, y, -1.5f);
      if (has_cellar && x > 0.0f)
        shifted.cloud->emplace_back (x, y, -4.0f);
    }
  shifted.cloud->emplace_back (0.0f, 2.0f, 1.0f); // of a wall
  shifted.cloud->sensor_origin_.head<3>() = sensor.cast<float>();
  return shifted;
}

FileCloud
survey ()
{
  FileCloud cloud;
  cloud.is_survey = true;
  return cloud;
}

/** \brief Whether a tenth of the points on planes, or more, are on floors. */
bool
hasFloor (const std::vector<PlaneSegment>& planes, const std::vector<PlaneKind>& kinds)
{
  std::size_t on_floors = 0;
  std::size_t all = 0;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    all += planes[i].inliers.size();
    on_floors += kinds[i] == PlaneKind::Floor ? planes[i].inliers.size() : 0;
  }
  return 10 * on_floors >= all;
}

} // namespace

TEST (KnownSensor, IsWhereTheCloudWasSeenFrom)
{
  const Vector3d place (1, 1, 0.5);
  EXPECT_EQ (knownSensor (FileCloud(), floorBelow (place, false)), place);
  EXPECT_EQ (knownSensor (FileCloud(), floorBelow (place, true)), std::nullopt)
      << "the cellar is behind the floor";
}

TEST (KnownSensor, IsInTheFrameOfTheFile)
{
  ShiftedCloud shifted = floorBelow ({0, 0, 0}, false);
  shifted.shift = {500, 600, 70};
  EXPECT_EQ (knownSensor (FileCloud(), shifted), shifted.shift);
}

TEST (KnownSensor, IsNoneOfACloudOfTwoScans)
{
  FileCloud cloud;
  cloud.scans.resize (2);
  EXPECT_EQ (knownSensor (cloud, floorBelow ({0, 0, 0}, false)), std::nullopt);
}

TEST (KnownSensor, OfASurveyIsAmidItsPointsOrNone)
{
  const Vector3d amid (1, 1, 0.5);
  EXPECT_EQ (knownSensor (survey(), floorBelow (amid, false)), amid);
  EXPECT_EQ (knownSensor (survey(), floorBelow ({0, 0, 9}, false)), std::nullopt);
}

// Of each lidar scan there is.
TEST (KnownSensor, TellsKindsThatNoGroundIsACeilingEvenWhereTheSensorLeans)
{
  const auto scans = lidarScansIn (PCL_OPS_DATA_DIR);
  if (scans.empty())
    GTEST_SKIP() << "no lidar scans in " << PCL_OPS_DATA_DIR;
  for (const auto& file : scans) {
    const FileCloud cloud = loadCloud (file.string());
    const ShiftedCloud shifted = shiftedCloudOf (cloud, 0.0);
    const auto sensor = knownSensor (cloud, shifted);
    ASSERT_EQ (sensor, Vector3d::Zero()) << file;
    std::vector<PlaneSegment> planes =
        detectPlanes (CloudView (*shifted.cloud), OrientedPointSamplingParameters());
    std::vector<PlaneExtent> extents;
    for (const PlaneSegment& plane : planes)
      extents.push_back (planeExtent (*shifted.cloud, plane));
    const auto kinds = planeKinds (planes, extents, Vector3d::UnitZ(), 1.0, sensor);
    for (std::size_t i = 0; i < planes.size(); ++i)
      EXPECT_FALSE (kinds[i] == PlaneKind::Ceiling && planes[i].centroid.z() < 0.0)
          << file << ", plane " << i + 1;
    // As it would be named by a sensor that leans by 7 degrees more.
    const Eigen::AngleAxisd lean (paper_angle_tolerance, Vector3d::UnitX());
    const Vector3d up = lean * Vector3d::UnitZ();
    for (PlaneSegment& plane : planes)
      plane.orientation = orientationOf (plane.normal, up, paper_angle_tolerance);
    const auto leaning = planeKinds (planes, extents, up, 1.0, sensor);
    EXPECT_EQ (hasFloor (planes, kinds), hasFloor (planes, leaning)) << file;
  }
}
