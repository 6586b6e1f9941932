// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "simulated_scenes.h"
#include <simulation/shapes.h>
#include <simulation/street.h>
#include <simulation/survey.h>

#include <functional>

using namespace pcl_ops::simulation;

namespace {

SimulatedCloud
imageOf (const Room& room, std::uint32_t seed, double noise, CloudLayout layout)
{
  const Eigen::Isometry3d pose = drawCameraPose (room, seed);
  const NoiseParameters parameters = noiseOf (NoiseProfile::Correlated, noise);
  const Scan scan =
      scanByCamera (room.scene, cameraOf (160, 120), pose, parameters, seed);
  return toCloud (scan, pose, room.scene, layout);
}

SimulatedCloud
imageOfRoom (std::uint32_t seed, CloudLayout layout = CloudLayout::Readings)
{
  return imageOf (makeRoom (seed), seed, 1.0, layout);
}

SimulatedCloud
scanOfStreet (std::uint32_t seed, double noise, const std::string& sensor)
{
  const Street street = makeStreet (seed);
  const Eigen::Isometry3d pose = drawSensorPose (street, seed);
  const Scan scan = scanAround (street.scene, lidarOf (sensor), pose, noise, seed);
  return toCloud (scan, pose, street.scene, CloudLayout::Readings);
}

/** \brief What the program makes of a seed, smaller. */
struct Kind {
  const char* name;
  std::function<SimulatedCloud (std::uint32_t seed, double noise)> simulate;
  /** \brief Of points, by how far they are from the origin [m]. */
  double largest_rounding;
  /** \brief Of the distance to the plane; 0: it grows with the depth [m]. */
  double sigma;
};

const std::vector<Kind> kinds = {
    {"room",
     [] (auto seed, double noise) {
       return imageOf (makeRoom (seed), seed, noise, CloudLayout::Readings);
     },
     rounding,
     0.0},
    {"corner",
     [] (auto seed, double noise) {
       return imageOf (makeFurnishedCorner (seed), seed, noise, CloudLayout::Readings);
     },
     rounding,
     0.0},
    {"scan of a room",
     [] (auto seed, double noise) {
       return scanDensely (makeRoom (seed).scene, 50000, noise, seed);
     },
     rounding,
     laser_sigma},
    {"scan of a corner",
     [] (auto seed, double noise) {
       return scanDensely (makeFurnishedCorner (seed).scene, 5000, noise, seed);
     },
     rounding,
     laser_sigma},
    {"shapes",
     [] (auto seed, double noise) {
       return scanShapes (makeShapes (seed), 5000, noise, seed);
     },
     rounding,
     shapes_sigma},
    {"survey",
     [] (auto seed, double noise) {
       return scanSurvey (makeSurvey (seed, 4), 10000, noise, seed);
     },
     5.0 * rounding,
     std::sqrt (3.0) * survey_sigma},
    {"street",
     [] (auto seed, double noise) { return scanOfStreet (seed, noise, "lidar-16"); },
     50.0 * rounding,
     lidar_sigma},
    {"street by a rosette",
     [] (auto seed, double noise) { return scanOfStreet (seed, noise, "livox"); },
     50.0 * rounding,
     lidar_sigma}};

} // namespace

TEST (Clouds, SameSeedSameCloud)
{
  const std::uint32_t seed = seedOfTest();
  for (const Kind& kind : kinds) {
    const SimulatedCloud first = kind.simulate (seed, 1.0);
    EXPECT_TRUE (haveSamePoints (first, kind.simulate (seed, 1.0))) << kind.name;
    EXPECT_FALSE (haveSamePoints (first, kind.simulate (seed + 1, 1.0))) << kind.name;
  }
}

TEST (Clouds, ExactPointsLieOnThePlaneOfTheirLabel)
{
  for (const Kind& kind : kinds) {
    const SimulatedCloud exact = kind.simulate (seedOfTest(), 0.0);
    EXPECT_GE (exact.planes.size(), 2u) << kind.name;
    EXPECT_LT (largestDistanceToTruth (exact), kind.largest_rounding) << kind.name;
  }
}

TEST (Clouds, NoisyPointsLieAroundThePlaneOfTheirLabel)
{
  for (const Kind& kind : kinds) {
    const double largest = largestDistanceToTruth (kind.simulate (seedOfTest(), 2.0));
    EXPECT_GT (largest, 2.0 * kind.sigma) << kind.name;
    if (kind.sigma > 0.0) {
      EXPECT_LT (largest, 2.0 * largest_gaussian * kind.sigma + kind.largest_rounding)
          << kind.name;
    }
  }
}

TEST (Clouds, LabelsCountDownBySize)
{
  for (const Kind& kind : kinds) {
    const SimulatedCloud simulated = kind.simulate (seedOfTest(), 1.0);
    std::vector<std::size_t> counts (simulated.planes.size() + 1, 0);
    for (const auto& point : simulated.cloud)
      ++counts.at (point.label);
    for (std::size_t i = 0; i < simulated.planes.size(); ++i) {
      const LabeledPlane& plane = simulated.planes[i];
      EXPECT_EQ (plane.label, i + 1) << kind.name;
      EXPECT_EQ (plane.points, counts[i + 1]) << kind.name;
      EXPECT_GE (plane.points, min_points_of_plane) << kind.name;
      EXPECT_LE (plane.points, simulated.planes[i > 0 ? i - 1 : 0].points) << kind.name;
    }
  }
}

TEST (Clouds, RoomsHaveManyPlanesBeforeTheCamera)
{
  for (const std::uint32_t seed : seedsOfTest (10)) {
    const SimulatedCloud image = imageOfRoom (seed);
    EXPECT_GE (image.planes.size(), 5u) << seed;
    EXPECT_GT (image.cloud.size(), 160u * 120u * 8u / 10u) << seed;
  }
}

TEST (Clouds, StreetsHaveManyPlanesOfWhichTheRoadIsTheLargest)
{
  for (const std::uint32_t seed : seedsOfTest (3)) {
    const auto planes = scanOfStreet (seed, 1.0, "lidar-64").planes;
    ASSERT_GE (planes.size(), 30u) << seed;
    EXPECT_GT (std::abs (planes[0].plane.normal.z()), 1.0 - rounding) << seed;
  }
}

TEST (Clouds, OrganizedOnesKeepEveryPixelAndOnlyAddNan)
{
  const SimulatedCloud organized = imageOfRoom (seedOfTest(), CloudLayout::Organized);
  EXPECT_EQ (organized.cloud.width, 160u);
  EXPECT_EQ (organized.cloud.height, 120u);
  EXPECT_FALSE (organized.cloud.is_dense);
  SimulatedCloud finite;
  for (const auto& point : organized.cloud)
    if (std::isfinite (point.x))
      finite.cloud.push_back (point);
  EXPECT_TRUE (haveSamePoints (finite, imageOfRoom (seedOfTest())));
}

TEST (Clouds, SensorPoseLeadsBackToThePixels)
{
  const auto cloud = imageOfRoom (seedOfTest(), CloudLayout::Organized).cloud;
  const Eigen::Matrix3f to_camera = cloud.sensor_orientation_.conjugate().matrix();
  for (std::size_t i = 0; i < cloud.size(); i += 97) {
    if (!std::isfinite (cloud[i].x))
      continue;
    const Eigen::Vector3f seen =
        to_camera * (cloud[i].getVector3fMap() - cloud.sensor_origin_.head<3>());
    const double column = 0.5 * 159 + 525.0 / 4.0 * seen.x() / seen.z();
    EXPECT_NEAR (column, double (i % 160), 1e-3);
  }
}

TEST (Clouds, DenseScansCoverSurfacesByArea)
{
  Scene scene = wallAt (1.0); // 40 m x 40 m
  Body half;
  addSurface (half, rectangleAlong (0, 1, {0.0, 0.0, 0.0}, 10.0, 20.0));
  addBody (scene, half, Eigen::Isometry3d::Identity());
  const auto planes = scanDensely (scene, 30000, 1.0, seedOfTest()).planes;
  ASSERT_EQ (planes.size(), 2u);
  EXPECT_EQ (planes[0].points, 20000u);
  EXPECT_EQ (planes[1].points, 10000u);
}
