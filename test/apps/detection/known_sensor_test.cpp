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

enum class Cellar { None, BelowHalfOfTheFloor };

/** \brief A floor of 4 m x 4 m at z = -1.5 m and a point of a wall at z = 1 m: the
 * bounding box ends there.
 * \param[in] sensor position of the sensor according to the cloud [m]
 * \param[in] cellar half of the floor may be there a second time, 2.5 m lower */
ShiftedCloud
floorSeenFrom (const Vector3d& sensor, Cellar cellar = Cellar::None)
{
  ShiftedCloud shifted{XyzCloud::Ptr (new XyzCloud)};
  for (float x = -2.0f; x < 2.0f; x += 0.02f)
    for (float y = -2.0f; y < 2.0f; y += 0.02f) {
      shifted.cloud->emplace_back (x, y, -1.5f);
      if (cellar == Cellar::BelowHalfOfTheFloor && x > 0.0f)
        shifted.cloud->emplace_back (x, y, -4.0f);
    }
  shifted.cloud->emplace_back (0.0f, 2.0f, 1.0f);
  shifted.cloud->sensor_origin_.head<3>() = sensor.cast<float>();
  return shifted;
}

/** \brief The file of a survey, without its points. */
FileCloud
surveyFile ()
{
  FileCloud cloud;
  cloud.is_survey = true;
  return cloud;
}

/** \brief The planes of a lidar scan. */
struct ScannedPlanes {
  std::vector<PlaneSegment> planes;
  std::vector<PlaneExtent> extents;
  std::optional<Vector3d> sensor;

  /** \brief The kind of each plane.
   * \param[in] up direction against gravity */
  std::vector<PlaneKind>
  kinds (const Vector3d& up) const
  {
    constexpr double meter = 1.0; // the scans are in meters
    return planeKinds (planes, extents, up, meter, sensor);
  }
};

ScannedPlanes
planesOfScan (const std::string& file)
{
  const FileCloud cloud = loadCloud (file);
  const ShiftedCloud shifted = shiftedCloudOf (cloud);
  ScannedPlanes scanned;
  scanned.sensor = knownSensor (cloud, shifted);
  scanned.planes =
      detectPlanes (CloudView (*shifted.cloud), OrientedPointSamplingParameters());
  for (const PlaneSegment& plane : scanned.planes)
    scanned.extents.push_back (planeExtent (*shifted.cloud, plane));
  return scanned;
}

/** \brief Whether at least a tenth of the points on planes are on floors. */
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

TEST (KnownSensor, IsThePositionInTheCloudUnlessTheCloudIsNotSeenFromThere)
{
  const Vector3d sensor (1, 1, 0.5);
  EXPECT_EQ (knownSensor (FileCloud(), floorSeenFrom (sensor)), sensor);
  EXPECT_EQ (
      knownSensor (FileCloud(), floorSeenFrom (sensor, Cellar::BelowHalfOfTheFloor)),
      std::nullopt)
      << "the floor hides the cellar";
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

TEST (KnownSensor, OfASurveyIsInTheBoundingBoxOfItsPointsOrNone)
{
  const Vector3d inside (1, 1, 0.5), above (0, 0, 9);
  EXPECT_EQ (knownSensor (surveyFile(), floorSeenFrom (inside)), inside);
  EXPECT_EQ (knownSensor (surveyFile(), floorSeenFrom (above)), std::nullopt);
}

TEST (KnownSensor, LetsNoPlaneBelowItBeACeilingAndKeepsFloorsWhereItLeans)
{
  const auto scans = lidarScansIn (PCL_OPS_DATA_DIR);
  if (scans.empty())
    GTEST_SKIP() << "no lidar scans in " << PCL_OPS_DATA_DIR;
  for (const auto& file : scans) {
    ScannedPlanes scanned = planesOfScan (file.string());
    ASSERT_EQ (scanned.sensor, Vector3d::Zero()) << file;
    std::vector<PlaneSegment>& planes = scanned.planes;
    ASSERT_FALSE (planes.empty()) << file;
    const std::vector<PlaneKind> kinds = scanned.kinds (Vector3d::UnitZ());
    for (std::size_t i = 0; i < planes.size(); ++i)
      EXPECT_FALSE (kinds[i] == PlaneKind::Ceiling && planes[i].centroid.z() < 0.0)
          << file << ", plane " << i + 1;
    // The same with an up axis that is off by 7 degrees, as of a sensor that leans.
    const Eigen::AngleAxisd lean (paper_angle_tolerance, Vector3d::UnitX());
    const Vector3d leaning_up = lean * Vector3d::UnitZ();
    for (PlaneSegment& plane : planes)
      plane.orientation =
          orientationOf (plane.normal, leaning_up, paper_angle_tolerance);
    EXPECT_EQ (hasFloor (planes, kinds), hasFloor (planes, scanned.kinds (leaning_up)))
        << file;
  }
}
