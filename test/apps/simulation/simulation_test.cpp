// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_checks.h"
#include "simulated_scene.h"
#include <simulation/dense_scan.h>
#include <simulation/simulated_cloud.h>

#include <algorithm>
#include <cmath>

using namespace pcl_ops::simulation;

namespace {

/** \brief What the program makes of a seed. */
SimulatedCloud
roomCloud (std::uint32_t seed, const NoiseParameters& noise, CloudLayout layout)
{
  const Room room = makeRoom (seed);
  DepthCamera camera = smallCamera();
  camera.pose = drawCameraPose (room, camera, seed);
  return toCloud (
      measureDepth (room.scene, camera, noise, seed), camera, room.scene, layout);
}

} // namespace

TEST (Scene, RayMeetsTheNearestShape)
{
  Scene scene = stepScene (2.0, 4.0);
  const Hit left = castRay (scene, Eigen::Vector3d::Zero(), {-0.1, 0.0, 1.0});
  const Hit right = castRay (scene, Eigen::Vector3d::Zero(), {0.1, 0.0, 1.0});
  EXPECT_DOUBLE_EQ (left.distance, 2.0);
  EXPECT_DOUBLE_EQ (right.distance, 4.0);
  EXPECT_NE (left.surface, right.surface);
}

TEST (Scene, RayMeetsRoundThingsOnTheirSkin)
{
  Body round;
  round.spheres.push_back ({{0.0, 0.0, 3.0}, 0.5});
  round.cylinders.push_back ({{2.0, 0.0, 3.0}, Eigen::Vector3d::UnitY(), 1.0, 0.5});
  Scene scene;
  addBody (scene, round, Eigen::Isometry3d::Identity());
  const Eigen::Vector3d forward = Eigen::Vector3d::UnitZ();
  EXPECT_DOUBLE_EQ (castRay (scene, {0.0, 0.0, 0.0}, forward).distance, 2.5);
  EXPECT_DOUBLE_EQ (castRay (scene, {2.0, 0.9, 0.0}, forward).distance, 2.5);
  EXPECT_TRUE (std::isinf (castRay (scene, {2.0, 1.1, 0.0}, forward).distance));
}

TEST (Scene, RayMeetsTheEndOfACylinder)
{
  Body bin;
  bin.cylinders.push_back ({{0.0, 0.0, 3.0}, Eigen::Vector3d::UnitZ(), 1.0, 0.5});
  Scene scene;
  addBody (scene, bin, Eigen::Isometry3d::Identity());
  const Hit hit = castRay (scene, {0.2, 0.0, 0.0}, {0.01, 0.0, 1.0});
  EXPECT_NEAR (hit.distance, 2.0, 1e-12);
  EXPECT_EQ (hit.surface, no_surface);
}

TEST (Scene, FacesOfABoxAreSurfacesOfTheirOwnUnlessNarrow)
{
  Body board;
  addBox (board, Eigen::Isometry3d::Identity(), {1.0, 0.6, 0.03});
  EXPECT_EQ (board.rectangles.size(), 6u);
  EXPECT_EQ (board.surface_count, 2u);
}

TEST (Room, IsFurnishedWithinItsWalls)
{
  for (std::uint32_t seed = seedOfTest(), last = seed + 20; seed != last; ++seed) {
    const Room room = makeRoom (seed);
    EXPECT_GT (room.scene.bodies.size(), 4u);
    const Eigen::AngleAxisd unturn (-room.yaw, Eigen::Vector3d::UnitZ());
    for (std::size_t i = 1; i < room.scene.bodies.size(); ++i) {
      const Eigen::Vector3d center = unturn * room.scene.bounds[i].center;
      EXPECT_LT (2.0 * std::abs (center.x()), room.size.x()) << seed;
      EXPECT_LT (2.0 * std::abs (center.y()), room.size.y()) << seed;
    }
  }
}

TEST (Room, HasManyPlanesBeforeTheCamera)
{
  for (std::uint32_t seed = seedOfTest(), last = seed + 10; seed != last; ++seed) {
    const auto simulated = roomCloud (seed, {}, CloudLayout::Readings);
    EXPECT_GE (simulated.planes.size(), 5u) << seed;
    EXPECT_GT (simulated.cloud.size(), 160u * 120u * 8u / 10u) << seed;
  }
}

TEST (SimulatedCloud, ExactPointsLieOnThePlaneOfTheirLabel)
{
  NoiseParameters silent;
  silent.scale = 0.0;
  const auto simulated = roomCloud (seedOfTest(), silent, CloudLayout::Readings);
  EXPECT_LT (largestDistanceToTruth (simulated), rounding);
}

TEST (SimulatedCloud, LabelsCountDownBySize)
{
  const auto simulated = roomCloud (seedOfTest(), {}, CloudLayout::Readings);
  for (std::size_t i = 0; i < simulated.planes.size(); ++i) {
    const auto& plane = simulated.planes[i];
    const auto points = std::count_if (
        simulated.cloud.begin(), simulated.cloud.end(), [&plane] (const auto& point) {
          return point.label == plane.label;
        });
    EXPECT_EQ (plane.label, i + 1);
    EXPECT_EQ (plane.points, std::size_t (points));
    EXPECT_GE (plane.points, fewest_points_of_plane);
    if (i > 0) {
      EXPECT_LE (plane.points, simulated.planes[i - 1].points);
    }
  }
}

TEST (SimulatedCloud, SameSeedSameCloud)
{
  const std::uint32_t seed = seedOfTest();
  const auto first = roomCloud (seed, {}, CloudLayout::Readings);
  EXPECT_TRUE (haveSamePoints (first, roomCloud (seed, {}, CloudLayout::Readings)));
  EXPECT_FALSE (
      haveSamePoints (first, roomCloud (seed + 1, {}, CloudLayout::Readings)));
}

TEST (SimulatedCloud, OrganizedKeepsEveryPixelAndOnlyAddsNan)
{
  const auto readings = roomCloud (seedOfTest(), {}, CloudLayout::Readings);
  auto organized = roomCloud (seedOfTest(), {}, CloudLayout::Organized);
  EXPECT_EQ (organized.cloud.width, 160u);
  EXPECT_EQ (organized.cloud.height, 120u);
  EXPECT_FALSE (organized.cloud.is_dense);
  SimulatedCloud finite;
  for (const auto& point : organized.cloud)
    if (std::isfinite (point.x))
      finite.cloud.push_back (point);
  EXPECT_TRUE (haveSamePoints (finite, readings));
}

TEST (SimulatedCloud, SensorPoseLeadsBackToThePixels)
{
  const auto organized = roomCloud (seedOfTest(), {}, CloudLayout::Organized).cloud;
  const Eigen::Matrix3f to_camera = organized.sensor_orientation_.conjugate().matrix();
  for (std::size_t i = 0; i < organized.size(); i += 97) {
    if (!std::isfinite (organized[i].x))
      continue;
    const Eigen::Vector3f seen = to_camera * (organized[i].getVector3fMap() -
                                              organized.sensor_origin_.head<3>());
    const double column = 0.5 * 159 + 525.0 / 4.0 * seen.x() / seen.z();
    EXPECT_NEAR (column, double (i % 160), 1e-3);
  }
}

TEST (DenseScan, HasExactlyThePointsAskedFor)
{
  const Room room = makeRoom (seedOfTest());
  for (const std::size_t points : {1u, 999u, 100003u})
    EXPECT_EQ (scanDensely (room.scene, points, 1.0, 1).cloud.size(), points);
}

TEST (DenseScan, ExactPointsLieOnThePlaneOfTheirLabel)
{
  const Room room = makeRoom (seedOfTest());
  EXPECT_LT (largestDistanceToTruth (scanDensely (room.scene, 50000, 0.0, 1)),
             rounding);
}

TEST (DenseScan, CoversSurfacesByArea)
{
  Scene scene = wallAt (1.0); // 40 m x 40 m
  Body half;
  Rectangle rectangle;
  rectangle.half_u = 10.0;
  rectangle.half_v = 20.0;
  addSurface (half, rectangle);
  addBody (scene, half, Eigen::Isometry3d::Identity());
  const auto planes = scanDensely (scene, 30000, 1.0, seedOfTest()).planes;
  ASSERT_EQ (planes.size(), 2u);
  EXPECT_EQ (planes[0].points, 20000u);
  EXPECT_EQ (planes[1].points, 10000u);
}
