// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "simulated_scenes.h"
#include <simulation/shapes.h>
#include <simulation/simulate.h>
#include <simulation/survey.h>

using namespace pcl_ops::simulation;

namespace {

/** \brief A scene and how it is seen. */
struct Kind {
  const char* scene;
  std::optional<double> points;
  /** \brief Of points, by how far they are from the origin [m]. */
  double largest_rounding;
  /** \brief Of the distance to the plane; 0: it grows with the depth [m]. */
  double sigma;
  const char* sensor = "lidar-16";

  SimulatedCloud
  simulated (std::uint32_t seed, double noise = 1.0, bool organized = false) const
  {
    return simulate (
        {scene, seed, {160, 120}, false, sensor, noise, points, organized});
  }
};

const Kind room{"room", std::nullopt, rounding, 0.0};
const Kind street{"street", std::nullopt, 50.0 * rounding, lidar_sigma, "lidar-64"};
const std::vector<Kind> kinds = {
    room,
    {"furniture", std::nullopt, rounding, 0.0},
    {"room", 50000, rounding, laser_sigma},
    {"furniture", 5000, rounding, laser_sigma},
    {"shapes", 5000, rounding, shapes_sigma},
    {"survey", 90000, 50.0 * rounding, std::sqrt (3.0) * survey_sigma},
    {"street", std::nullopt, 50.0 * rounding, lidar_sigma},
    {"street", std::nullopt, 50.0 * rounding, lidar_sigma, "livox"}};

std::vector<std::size_t>
countsOf (const SimulatedCloud& simulated)
{
  std::vector<std::size_t> counts (simulated.planes.size() + 1, 0);
  for (const auto& point : simulated.cloud)
    ++counts.at (point.label);
  return counts;
}

} // namespace

TEST (Clouds, SameSeedSameCloud)
{
  for (const Kind& kind : kinds) {
    const SimulatedCloud first = kind.simulated (7);
    EXPECT_TRUE (haveSamePoints (first, kind.simulated (7))) << kind.scene;
    EXPECT_FALSE (haveSamePoints (first, kind.simulated (8))) << kind.scene;
  }
}

TEST (Clouds, PointsLieAboutThePlaneOfTheirLabelByTheNoise)
{
  for (const Kind& kind : kinds) {
    const SimulatedCloud exact = kind.simulated (seedOfTest(), 0.0);
    EXPECT_GE (exact.planes.size(), 2u) << kind.scene;
    EXPECT_LT (largestDistanceToTruth (exact), kind.largest_rounding) << kind.scene;
    const double largest = largestDistanceToTruth (kind.simulated (seedOfTest(), 2.0));
    EXPECT_GT (largest, 2.0 * kind.sigma) << kind.scene;
    if (kind.sigma > 0.0) {
      EXPECT_LT (largest, 2.0 * largest_gaussian * kind.sigma + kind.largest_rounding)
          << kind.scene;
    }
  }
}

TEST (Clouds, LabelsCountDownBySize)
{
  for (const Kind& kind : kinds) {
    const auto counts = countsOf (kind.simulated (seedOfTest()));
    EXPECT_TRUE (std::is_sorted (counts.rbegin(), counts.rend() - 1)) << kind.scene;
    EXPECT_GE (counts.back(), min_points_of_plane) << kind.scene;
  }
}

TEST (Clouds, RoomsAndStreetsHaveManyPlanes)
{
  for (const std::uint32_t seed : seedsOfTest (10)) {
    const SimulatedCloud image = room.simulated (seed);
    EXPECT_GE (image.planes.size(), 5u) << seed;
    EXPECT_GT (image.cloud.size(), 160u * 120u * 8u / 10u) << seed;
  }
  const auto planes = street.simulated (seedOfTest()).planes;
  ASSERT_GE (planes.size(), 30u);
  EXPECT_GT (std::abs (planes[0].normal.z()), 1.0 - rounding) << "the road";
}

TEST (Clouds, OrganizedOnesKeepEveryPixelAndOnlyAddNan)
{
  const SimulatedCloud organized = room.simulated (seedOfTest(), 1.0, true);
  EXPECT_EQ (organized.cloud.width, 160u);
  EXPECT_EQ (organized.cloud.height, 120u);
  EXPECT_FALSE (organized.cloud.is_dense);
  SimulatedCloud finite;
  for (const auto& point : organized.cloud)
    if (std::isfinite (point.x))
      finite.cloud.push_back (point);
  EXPECT_TRUE (haveSamePoints (finite, room.simulated (seedOfTest())));
}

TEST (Clouds, SensorPoseLeadsBackToThePixels)
{
  const auto cloud = room.simulated (seedOfTest(), 1.0, true).cloud;
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
  half.addSurface (makeRectangle ({0, 0, 0}, {20, 0, 0}, {0, 40, 0}));
  scene.add (half, Eigen::Isometry3d::Identity());
  EXPECT_EQ (countsOf (scanDensely (scene, 30000, 1.0, 1)),
             (std::vector<std::size_t>{0, 20000, 10000}));
}
