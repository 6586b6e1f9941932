// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "simulated_scenes.h"
#include <simulation/scenes.h>

#include <set>

using namespace pcl_ops::simulation;

namespace {

/** Returns the depth error of each pixel on a wall [m]. */
Field
errorsOn (double depth, const CameraNoise& noise)
{
  const Scan scan =
      scanByCamera ({wallsAt ({{0, 0, depth}}), origin, 7}, {160, 120}, noise);
  Field errors (120, 160);
  for (Eigen::Index i = 0; i < errors.size(); ++i)
    errors (i) = scan.points[std::size_t (i)].z() - depth;
  return errors;
}

/** Returns the correlation of the errors of pixels that are \p lag columns apart. */
double
correlation (const Field& errors, Eigen::Index lag)
{
  const Eigen::Index columns = errors.cols() - lag;
  return (errors.leftCols (columns) * errors.rightCols (columns)).mean() /
         errors.square().mean();
}

/** Scans with a lidar inside a box, which all rays hit. */
Scan
scanInABox (const Lidar& lidar, std::size_t number = 0, double noise = 0.0)
{
  Body box;
  box.addBox (origin, {9.0, 8.0, 7.0});
  Scene scene;
  scene.add (box, origin);
  return scanAround ({scene, origin, 1}, lidar, noise, number);
}

double
degreesBetween (const Isometry3d& one, const Isometry3d& other)
{
  return Eigen::AngleAxisd (one.linear().transpose() * other.linear()).angle() / degree;
}

double
stepOf (const Poses& poses, std::size_t i)
{
  return (poses[i].translation() - poses[i - 1].translation()).norm();
}

} // namespace

TEST (DepthNoise, GrowsWithTheSquareOfTheDepth)
{
  CameraNoise noise;
  noise.smoothing = 1.0; // fewer pixels err alike than by default
  for (const double depth : {1.0, 2.0, 4.0}) {
    const double sigma = std::sqrt (errorsOn (depth, noise).square().mean());
    const double expected = 0.0012 + 0.0019 * (depth - 0.4) * (depth - 0.4);
    EXPECT_NEAR (sigma / expected, 1.0, 0.1) << depth << " m";
  }
}

TEST (DepthNoise, CorrelatedErrorsAreThoseOfAGaussianFilter)
{
  const CameraNoise noise;
  const Field errors = errorsOn (3.0, noise);
  for (const int lag : {1, 3, 6}) {
    const double expected = std::exp (-0.25 * std::pow (lag / noise.smoothing, 2));
    EXPECT_NEAR (correlation (errors, lag), expected, 0.1) << lag << " px";
  }
}

TEST (DepthNoise, RawErrorsAreIndependentInEighthsOfAPixelOfDisparity)
{
  CameraNoise noise;
  noise.is_raw = true;
  const Field errors = errorsOn (3.0, noise);
  EXPECT_NEAR (correlation (errors, 1), 0.0, 0.05);
  // Disparities: focal length [px] times baseline [m] over depth.
  const Field eighths = 8.0 * 525.0 * 0.075 / (3.0 + errors);
  EXPECT_LT ((eighths - eighths.round()).abs().maxCoeff(), 1e-9);
}

TEST (DepthNoise, FlyingPixelsAreBetweenTheEdgesSidesAndOnNoSurface)
{
  const Scene step = wallsAt ({{0, 0, 4}, {-20, 0, 2}});
  const Scan image = scanByCamera ({step, origin, 7}, {160, 120}, {});
  int flying = 0;
  for (std::size_t i = 0; i < image.points.size(); ++i)
    if (image.points[i].z() > 2.1 && image.points[i].z() < 3.85) {
      ++flying;
      EXPECT_EQ (image.surfaces[i], no_surface);
    }
  EXPECT_GT (flying, 20);
  EXPECT_LT (flying, 2 * 120); // at most the pixels on both sides of the edge
}

TEST (DepthNoise, LosesWhatIsOutOfRange)
{
  for (const double depth : {0.4, 9.0})
    EXPECT_TRUE (errorsOn (depth, {0.0}).isNaN().all());
}

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
  const Scan first = scanInABox (livox), second = scanInABox (livox, 1);
  double widest = 0.0;
  for (const auto& point : first.points)
    widest = std::max (widest, std::acos (point.x() / point.norm()));
  EXPECT_NEAR (widest, 35.0 * degree, 0.01 * degree);
  EXPECT_FALSE (first.points[0].isApprox (second.points[0], 1e-3));
}

TEST (Lidar, NoiseIsAlongTheRays)
{
  const Lidar lidar = lidarOf ("lidar-16");
  const Scan exact = scanInABox (lidar), noisy = scanInABox (lidar, 0, 2.0);
  double squares = 0.0;
  for (std::size_t i = 0; i < exact.points.size(); ++i) {
    const Vector3d error = noisy.points[i] - exact.points[i];
    EXPECT_LT (error.cross (exact.points[i]).norm(), 1e-9);
    squares += error.squaredNorm();
  }
  EXPECT_NEAR (std::sqrt (squares / double (exact.points.size())), 0.04, 0.001);
}

TEST (Lidar, ReadsNothingBeyondItsRangeInRowsOfABeam)
{
  Lidar lidar = lidarOf ("lidar-16");
  lidar.farthest = 4.2;
  constexpr bool organized = true;
  const auto cloud = toSurfaceCloud (scanInABox (lidar), origin, organized);
  ASSERT_EQ (cloud.width, std::uint32_t (lidar.steps));
  std::size_t readings = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const float distance = cloud[i].getVector3fMap().norm();
    if (!std::isfinite (distance))
      continue;
    ++readings;
    EXPECT_LE (distance, lidar.farthest + rounding);
    const double elevation = 15.0 - 2.0 * double (i / cloud.width);
    EXPECT_NEAR (std::asin (cloud[i].z / distance), elevation * degree, 1e-6);
  }
  EXPECT_GT (readings, 0u);
  EXPECT_LT (readings, cloud.size());
}

TEST (Walk, StaysInTheRoomAndSeesSurfacesAllTheWay)
{
  for (std::uint32_t seed = 16; seed <= 25; ++seed) { // any ten seeds
    const Site room = makeRoom (seed);
    const Poses walk = drawWalk (room, 12, seed);
    ASSERT_EQ (walk.size(), 12u);
    for (const Isometry3d& pose : walk) {
      const Vector3d inside = turnZ (-room.yaw) * pose.translation();
      EXPECT_LT (std::abs (inside.x()), 0.5 * room.size.x());
      EXPECT_LT (std::abs (inside.y()), 0.5 * room.size.y());
      EXPECT_GE (countVisibleSurfaces (room.scene, pose), 3) << seed;
    }
  }
}

TEST (Walk, GoesInSmallStepsAndTurnsByThreeQuartersOfATurn)
{
  const Poses poses = drawWalk (makeRoom (2), 50, 2);
  double turned = 0.0;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    EXPECT_LT (stepOf (poses, i), 0.4);
    EXPECT_LT (degreesBetween (poses[i], poses[i - 1]), 15.0);
    turned += degreesBetween (poses[i], poses[i - 1]);
  }
  EXPECT_GT (turned, 250.0); // the path is 270 degrees of a turn
}

TEST (Drive, GoesInSmallStepsAboveTheRoad)
{
  const Site street = makeStreet (1);
  const Poses poses = drawDrive (street, 20, 1);
  ASSERT_EQ (poses.size(), 20u);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    EXPECT_NEAR (poses[i].translation().z(), 1.8, 0.11); // 1.7 to 1.9 m
    EXPECT_LT (poses[i].translation().head<2>().norm(), 0.25 * street.size.x() + 1.0);
    EXPECT_LT (i > 0 ? stepOf (poses, i) : 0.0, 1.1);
  }
}

TEST (Poses, AreMeasuredAsWellAsAskedAndDriftFromWhereTheyBegan)
{
  const Poses truth (2000, origin);
  EXPECT_TRUE (measuredPoses (truth, {}, 1)[7].isApprox (origin));
  double degrees = 0.0, shift = 0.0;
  for (const Isometry3d& pose : measuredPoses (truth, {3.0, 0.0}, 1)) {
    degrees += std::pow (degreesBetween (pose, origin), 2);
    shift += pose.translation().squaredNorm();
  }
  EXPECT_NEAR (std::sqrt (degrees / 2000), 3.0, 0.15);
  EXPECT_NEAR (std::sqrt (shift / 2000), 0.03, 0.0015);
  const Poses off = measuredPoses (truth, {0.0, 0.1}, 1);
  EXPECT_TRUE (off[0].isApprox (origin));
  EXPECT_LT (degreesBetween (off[1], off[0]), 0.5);
  EXPECT_GT (off[399].translation().norm(), 5.0 * off[1].translation().norm());
}
