// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_checks.h"
#include "simulated_scene.h"
#include <simulation/draws.h>
#include <simulation/street.h>
#include <simulation/street_things.h>

#include <cmath>
#include <set>

using namespace pcl_ops::simulation;

namespace {

constexpr double degree = pi / 180.0;

/** \brief What the program makes of a seed. */
SimulatedCloud
streetCloud (std::uint32_t seed, const std::string& sensor, double noise = 1.0)
{
  const Street street = makeStreet (seed);
  Lidar lidar = lidarOf (sensor);
  lidar.pose = drawSensorPose (street, seed);
  return toCloud (scanAround (street.scene, lidar, noise, seed),
                  lidar,
                  street.scene,
                  CloudLayout::Readings);
}

/** \brief A lidar inside of a box, which all rays meet. */
LidarScan
scanInABox (const Lidar& lidar, std::size_t number = 0, double noise = 0.0)
{
  Body box;
  addBox (box, Eigen::Isometry3d::Identity(), {9.0, 8.0, 7.0});
  Scene scene;
  addBody (scene, box, Eigen::Isometry3d::Identity());
  return scanAround (scene, lidar, noise, 1, number);
}

} // namespace

TEST (Lidar, HasTheBeamsOfItsName)
{
  for (const int beams : {64, 32, 16}) {
    std::set<long> elevations; // [0.001 degree]
    for (const auto& point :
         scanInABox (lidarOf ("lidar-" + std::to_string (beams))).points)
      elevations.insert (
          std::lround (1e3 / degree * std::asin (point.z() / point.norm())));
    EXPECT_EQ (elevations.size(), std::size_t (beams));
  }
}

TEST (Lidar, RosetteIsAConeThatIsDrawnAnewByEachScan)
{
  const Lidar livox = lidarOf ("livox");
  const LidarScan first = scanInABox (livox), second = scanInABox (livox, 1);
  double widest = 0.0;
  for (const auto& point : first.points)
    widest = std::max (widest, std::acos (point.x() / point.norm()));
  EXPECT_NEAR (widest, 35.0 * degree, 0.01 * degree);
  EXPECT_FALSE (first.points[0].isApprox (second.points[0], 1e-3));
}

TEST (Lidar, NoiseIsAlongTheRays)
{
  const Lidar lidar = lidarOf ("lidar-16");
  const LidarScan exact = scanInABox (lidar), noisy = scanInABox (lidar, 0, 2.0);
  double squares = 0.0;
  for (std::size_t i = 0; i < exact.points.size(); ++i) {
    const Eigen::Vector3d error = noisy.points[i] - exact.points[i];
    EXPECT_LT (error.cross (exact.points[i]).norm(), 1e-9);
    squares += error.squaredNorm();
  }
  EXPECT_NEAR (std::sqrt (squares / double (exact.points.size())), 0.04, 0.001);
}

TEST (Lidar, ReadsNothingBeyondItsRange)
{
  Lidar lidar = lidarOf ("lidar-16");
  lidar.farthest = 4.2;
  const LidarScan scan = scanInABox (lidar);
  std::size_t readings = 0;
  for (const auto& point : scan.points)
    if (std::isfinite (point.x())) {
      ++readings;
      EXPECT_LE (point.norm(), lidar.farthest + rounding);
    }
  EXPECT_GT (readings, 0u);
  EXPECT_LT (readings, scan.points.size());
}

TEST (Lidar, OrganizedRowsAreBeams)
{
  const Lidar lidar = lidarOf ("lidar-16");
  const auto cloud =
      toSurfaceCloud (scanInABox (lidar), lidar.pose, CloudLayout::Organized);
  ASSERT_EQ (cloud.width, std::uint32_t (lidar.steps));
  for (std::size_t i = 0; i < cloud.width; i += 100)
    EXPECT_NEAR (std::asin (cloud[i].z / cloud[i].getVector3fMap().norm()),
                 lidar.highest * degree,
                 1e-6);
}

TEST (Street, SameSeedSameCloud)
{
  for (const char* sensor : {"lidar-16", "livox"}) {
    const std::uint32_t seed = seedOfTest();
    const auto first = streetCloud (seed, sensor);
    EXPECT_TRUE (haveSamePoints (first, streetCloud (seed, sensor)));
    EXPECT_FALSE (haveSamePoints (first, streetCloud (seed + 1, sensor)));
  }
}

TEST (Street, PointsLieOnThePlaneOfTheirLabel)
{
  constexpr double rounding_of_street = 50.0 * rounding;
  for (std::uint32_t seed = seedOfTest(), last = seed + 3; seed != last; ++seed) {
    EXPECT_LT (largestDistanceToTruth (streetCloud (seed, "lidar-32", 0.0)),
               rounding_of_street);
    EXPECT_LT (largestDistanceToTruth (streetCloud (seed, "lidar-32")),
               largest_gaussian * lidar_sigma + rounding_of_street);
  }
}

TEST (Street, HasManyPlanesOfWhichTheRoadIsOne)
{
  for (std::uint32_t seed = seedOfTest(), last = seed + 3; seed != last; ++seed) {
    const auto planes = streetCloud (seed, "lidar-64").planes;
    ASSERT_GE (planes.size(), 30u) << seed;
    EXPECT_GT (std::abs (planes[0].plane.normal.z()), 1.0 - rounding) << seed;
  }
}

TEST (Street, PlantsAndPolesAreOnNoPlane)
{
  auto generator = makeGenerator (seedOfTest(), Purpose::Street);
  for (const Body& body :
       {makeTree (generator), makeBush (0.5, generator), makePole (generator)}) {
    EXPECT_EQ (body.surface_count, 0u);
    EXPECT_TRUE (body.rectangles.empty());
    EXPECT_FALSE (body.spheres.empty() && body.cylinders.empty());
  }
}

TEST (Street, WindowsOfAHouseAreOnePlaneBehindTheFacade)
{
  auto generator = makeGenerator (seedOfTest(), Purpose::Street);
  const Body house = makeTownHouse (12.0, generator);
  std::set<SurfaceId> facing;
  for (const Rectangle& rectangle : house.rectangles)
    if (std::abs (rectangle.normal().y()) > 0.99)
      facing.insert (rectangle.surface);
  EXPECT_EQ (facing.size(), 3u); // facade, windows, door
}

TEST (Street, DriveGoesInSmallStepsAboveTheRoad)
{
  const Street street = makeStreet (1);
  const Poses poses = drawDrive (street, 20, 1);
  ASSERT_EQ (poses.size(), 20u);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    EXPECT_NEAR (poses[i].translation().z(), 1.8, 0.11);
    EXPECT_LT (poses[i].translation().head<2>().norm(), 0.25 * street.length + 1.0);
    if (i > 0) {
      EXPECT_LT ((poses[i].translation() - poses[i - 1].translation()).norm(), 1.1);
    }
  }
}

TEST (Scene, DividedItMeetsRaysAsBefore)
{
  const Scene scene = makeRoom (seedOfTest()).scene;
  const Scene parts = divided (scene, 0.5);
  auto generator = makeGenerator (seedOfTest(), Purpose::Room);
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector3d ray = drawInBox (generator, {-1, -1, -1}, {1, 1, 1});
    const Hit hit = castRay (scene, {0.0, 0.0, 1.5}, ray);
    EXPECT_EQ (castRay (parts, {0.0, 0.0, 1.5}, ray).distance, hit.distance);
  }
}
