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

/** \brief A floor of 4 m x 4 m at z = -1.5 m and a point of a wall.
 * \param[in] sensor its origin [m]
 * \param[in] has_cellar half of the floor is there a second time, 2.5 m lower */
ShiftedCloud
floorSeenFrom (const Vector3d& sensor, bool has_cellar = false)
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
  const Vector3d sensor (1, 1, 0.5);
  constexpr bool with_cellar = true;
  EXPECT_EQ (knownSensor (FileCloud(), floorSeenFrom (sensor)), sensor);
  EXPECT_EQ (knownSensor (FileCloud(), floorSeenFrom (sensor, with_cellar)),
             std::nullopt)
      << "the cellar is behind the floor";
}

TEST (KnownSensor, IsInTheFrameOfTheFile)
{
  ShiftedCloud shifted = floorSeenFrom ({0, 0, 0});
  shifted.shift = {500, 600, 70};
  EXPECT_EQ (knownSensor (FileCloud(), shifted), shifted.shift);
}

TEST (KnownSensor, IsNoneOfACloudOfTwoScans)
{
  FileCloud cloud;
  cloud.scans.resize (2);
  EXPECT_EQ (knownSensor (cloud, floorSeenFrom ({0, 0, 0})), std::nullopt);
}

TEST (KnownSensor, OfASurveyIsAmidItsPointsOrNone)
{
  const Vector3d amid (1, 1, 0.5);
  EXPECT_EQ (knownSensor (survey(), floorSeenFrom (amid)), amid);
  EXPECT_EQ (knownSensor (survey(), floorSeenFrom ({0, 0, 9})), std::nullopt);
}

TEST (KnownSensor, TellsKindsThatNoGroundIsACeilingEvenWhereTheSensorLeans)
{
  // For all lidar scans in the data folder.
  const auto scans = lidarScansIn (PCL_OPS_DATA_DIR);
  if (scans.empty())
    GTEST_SKIP() << "no lidar scans in " << PCL_OPS_DATA_DIR;
  constexpr double meter = 1.0;
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
    const auto kinds = planeKinds (planes, extents, Vector3d::UnitZ(), meter, sensor);
    for (std::size_t i = 0; i < planes.size(); ++i)
      EXPECT_FALSE (kinds[i] == PlaneKind::Ceiling && planes[i].centroid.z() < 0.0)
          << file << ", plane " << i + 1;
    // The same with an up axis that is off by 7 degrees, as of a sensor that leans.
    const Eigen::AngleAxisd lean (paper_angle_tolerance, Vector3d::UnitX());
    const Vector3d up = lean * Vector3d::UnitZ();
    for (PlaneSegment& plane : planes)
      plane.orientation = orientationOf (plane.normal, up, paper_angle_tolerance);
    const auto kinds_of_leaning = planeKinds (planes, extents, up, meter, sensor);
    EXPECT_EQ (hasFloor (planes, kinds), hasFloor (planes, kinds_of_leaning)) << file;
  }
}
