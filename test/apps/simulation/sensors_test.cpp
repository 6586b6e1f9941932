// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "simulated_scenes.h"
#include <simulation/street.h>

#include <set>

using namespace pcl_ops::simulation;

namespace {

const Eigen::Isometry3d origin = Eigen::Isometry3d::Identity();

Scan
measuredWall (double depth, const CameraNoise& noise)
{
  return scanByCamera (wallAt (depth), {160, 120}, origin, noise, seedOfTest());
}

double
meanSquaredError (const Scan& image, double depth)
{
  double sum = 0.0;
  for (const Eigen::Vector3d& point : image.points)
    sum += (point.z() - depth) * (point.z() - depth);
  return sum / double (image.points.size());
}

/** \brief Correlation of the errors of pixels that are some columns apart. */
double
errorCorrelation (const Scan& image, double depth, std::size_t columns_apart)
{
  double sum = 0.0;
  int pairs = 0;
  for (std::size_t i = 0; i + columns_apart < image.points.size(); ++i)
    if (i % image.columns + columns_apart < image.columns) {
      sum +=
          (image.points[i].z() - depth) * (image.points[i + columns_apart].z() - depth);
      ++pairs;
    }
  return sum / pairs / meanSquaredError (image, depth);
}

/** \brief A lidar inside of a box, which all rays meet. */
Scan
scanInABox (const Lidar& lidar, std::size_t number = 0, double noise = 0.0)
{
  Body box;
  box.addBox (origin, {9.0, 8.0, 7.0});
  Scene scene;
  scene.add (box, origin);
  return scanAround (scene, lidar, origin, noise, 1, number);
}

double
degreesBetween (const Eigen::Isometry3d& one, const Eigen::Isometry3d& other)
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
  const CameraNoise noise{1.0, false, 1.0}; // independent errors: a surer estimate
  for (const double depth : {1.0, 2.0, 4.0}) {
    const double sigma =
        std::sqrt (meanSquaredError (measuredWall (depth, noise), depth));
    const double expected = 0.0012 + 0.0019 * (depth - 0.4) * (depth - 0.4);
    EXPECT_NEAR (sigma / expected, 1.0, 0.1) << depth << " m";
  }
}

TEST (DepthNoise, CorrelatedErrorsAreThoseOfAGaussianFilter)
{
  const CameraNoise noise;
  const Scan image = measuredWall (3.0, noise);
  for (const std::size_t lag : {1, 3, 6}) {
    const double expected =
        std::exp (-0.25 * double (lag * lag) / noise.smoothing / noise.smoothing);
    EXPECT_NEAR (errorCorrelation (image, 3.0, lag), expected, 0.1) << lag << " px";
  }
}

TEST (DepthNoise, RawErrorsAreIndependentInEighthsOfAPixelOfDisparity)
{
  const Scan image = measuredWall (3.0, {1.0, true});
  EXPECT_NEAR (errorCorrelation (image, 3.0, 1), 0.0, 0.05);
  for (const Eigen::Vector3d& point : image.points) {
    const double eighths = 8.0 * 525.0 * 0.075 / point.z();
    EXPECT_NEAR (eighths, std::round (eighths), 1e-9);
  }
}

TEST (DepthNoise, FlyingPixelsAreBetweenTheEdgesSidesAndOnNoSurface)
{
  const Scan image =
      scanByCamera (stepScene (2.0, 4.0), {160, 120}, origin, {}, seedOfTest());
  int flying = 0;
  for (std::size_t i = 0; i < image.points.size(); ++i)
    if (image.points[i].z() > 2.1 && image.points[i].z() < 3.85) {
      ++flying;
      EXPECT_EQ (image.surfaces[i], no_surface);
    }
  EXPECT_GT (flying, 20);
  EXPECT_LT (flying, 2 * 120);
}

TEST (DepthNoise, LosesWhatIsOutOfRange)
{
  for (const double depth : {0.4, 9.0})
    for (const Eigen::Vector3d& point : measuredWall (depth, {0.0}).points)
      EXPECT_TRUE (std::isnan (point.z()));
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
  const Scan scan = scanInABox (lidar);
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
  const auto cloud = toSurfaceCloud (scanInABox (lidar), origin, true);
  ASSERT_EQ (cloud.width, std::uint32_t (lidar.steps));
  for (std::size_t i = 0; i < cloud.width; i += 100)
    EXPECT_NEAR (std::asin (cloud[i].z / cloud[i].getVector3fMap().norm()),
                 lidar.highest * degree,
                 1e-6);
}

TEST (Walk, StaysInTheRoomAndSeesSurfacesAllTheWay)
{
  for (std::uint32_t seed = 16; seed <= 25; ++seed) {
    const Room room = makeRoom (seed);
    for (const Eigen::Isometry3d& pose : drawWalk (room, 12, seed)) {
      const Eigen::Vector3d inside = turnZ (-room.yaw) * pose.translation();
      EXPECT_LT (std::abs (inside.x()), 0.5 * room.size.x());
      EXPECT_LT (std::abs (inside.y()), 0.5 * room.size.y());
      EXPECT_GE (countVisibleSurfaces (room.scene, pose), 3) << seed;
    }
  }
}

TEST (Walk, GoesInSmallStepsAndLooksMostWaysInTheEnd)
{
  const Poses poses = drawWalk (makeRoom (2), 50, 2);
  double turned = 0.0;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    EXPECT_LT (stepOf (poses, i), 0.4);
    EXPECT_LT (degreesBetween (poses[i], poses[i - 1]), 15.0);
    turned += degreesBetween (poses[i], poses[i - 1]);
  }
  EXPECT_GT (turned, 250.0);
}

TEST (Drive, GoesInSmallStepsAboveTheRoad)
{
  const Street street = makeStreet (1);
  const Poses poses = drawDrive (street, 20, 1);
  ASSERT_EQ (poses.size(), 20u);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    EXPECT_NEAR (poses[i].translation().z(), 1.8, 0.11);
    EXPECT_LT (poses[i].translation().head<2>().norm(), 0.25 * street.length + 1.0);
    EXPECT_LT (i > 0 ? stepOf (poses, i) : 0.0, 1.1);
  }
}

TEST (Poses, AreMeasuredAsWellAsAsked)
{
  const Poses truth (2000, Eigen::Isometry3d::Identity());
  EXPECT_TRUE (measured (truth, {}, 1)[7].isApprox (truth[7]));
  double degrees = 0.0, shift = 0.0;
  for (const Eigen::Isometry3d& pose : measured (truth, {3.0, 0.0}, 1)) {
    degrees += std::pow (degreesBetween (pose, truth[0]), 2);
    shift += pose.translation().squaredNorm();
  }
  EXPECT_NEAR (std::sqrt (degrees / 2000), 3.0, 0.15);
  EXPECT_NEAR (std::sqrt (shift / 2000), 0.03, 0.0015);
}

TEST (Poses, DriftFromWhereTheyBegan)
{
  const Poses truth (400, Eigen::Isometry3d::Identity());
  const Poses off = measured (truth, {0.0, 0.1}, 1);
  EXPECT_TRUE (off[0].isApprox (truth[0]));
  EXPECT_LT (degreesBetween (off[1], off[0]), 0.5);
  EXPECT_GT (off[399].translation().norm(), 5.0 * off[1].translation().norm());
}
