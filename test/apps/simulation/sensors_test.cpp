// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "simulated_scenes.h"
#include <simulation/lidar.h>

#include <set>

using namespace pcl_ops::simulation;

namespace {

const Eigen::Isometry3d origin = Eigen::Isometry3d::Identity();

DepthImage
measuredWall (double depth, const NoiseParameters& noise)
{
  return measureDepth (
      wallAt (depth), cameraOf (160, 120), origin, noise, seedOfTest());
}

double
meanSquaredError (const DepthImage& image, double depth)
{
  double sum = 0.0;
  for (const double measured : image.depth)
    sum += (measured - depth) * (measured - depth);
  return sum / double (image.depth.size());
}

/** \brief Correlation of the errors of pixels that are some columns apart. */
double
errorCorrelation (const DepthImage& image, double depth, int columns_apart)
{
  double sum = 0.0;
  int pairs = 0;
  for (int row = 0; row < image.height; ++row)
    for (int column = 0; column + columns_apart < image.width; ++column, ++pairs) {
      const double* const pixel = &image.depth[row * image.width + column];
      sum += (pixel[0] - depth) * (pixel[columns_apart] - depth);
    }
  return sum / pairs / meanSquaredError (image, depth);
}

/** \brief A lidar inside of a box, which all rays meet. */
Scan
scanInABox (const Lidar& lidar, std::size_t number = 0, double noise = 0.0)
{
  Body box;
  addBox (box, origin, {9.0, 8.0, 7.0});
  Scene scene;
  addBody (scene, box, origin);
  return scanAround (scene, lidar, origin, noise, 1, number);
}

} // namespace

TEST (DepthNoise, GrowsWithTheSquareOfTheDepth)
{
  NoiseParameters noise = noiseOf (NoiseProfile::Correlated);
  noise.smoothing = 1.0; // more independent errors: a surer estimate
  for (const double depth : {1.0, 2.0, 4.0}) {
    const double sigma =
        std::sqrt (meanSquaredError (measuredWall (depth, noise), depth));
    const double expected = 0.0012 + 0.0019 * (depth - 0.4) * (depth - 0.4);
    EXPECT_NEAR (sigma / expected, 1.0, 0.1) << depth << " m";
  }
}

TEST (DepthNoise, CorrelatedErrorsAreThoseOfAGaussianFilter)
{
  const NoiseParameters noise = noiseOf (NoiseProfile::Correlated);
  const DepthImage image = measuredWall (3.0, noise);
  for (const int lag : {1, 3, 6}) {
    const double expected =
        std::exp (-0.25 * lag * lag / noise.smoothing / noise.smoothing);
    EXPECT_NEAR (errorCorrelation (image, 3.0, lag), expected, 0.1) << lag << " px";
  }
}

TEST (DepthNoise, RawErrorsAreIndependentInEighthsOfAPixelOfDisparity)
{
  const DepthImage image = measuredWall (3.0, noiseOf (NoiseProfile::Raw));
  EXPECT_NEAR (errorCorrelation (image, 3.0, 1), 0.0, 0.05);
  for (const double depth : image.depth) {
    const double eighths = 8.0 * 525.0 * 0.075 / depth;
    EXPECT_NEAR (eighths, std::round (eighths), 1e-9);
  }
}

TEST (DepthNoise, FlyingPixelsAreBetweenTheEdgesSidesAndOnNoSurface)
{
  const DepthImage image = measureDepth (
      stepScene (2.0, 4.0), cameraOf (160, 120), origin, {}, seedOfTest());
  int flying = 0;
  for (std::size_t i = 0; i < image.depth.size(); ++i)
    if (image.depth[i] > 2.1 && image.depth[i] < 3.85) {
      ++flying;
      EXPECT_EQ (image.surface[i], no_surface);
    }
  EXPECT_GT (flying, 20);
  EXPECT_LT (flying, 2 * 120);
}

TEST (DepthNoise, LosesWhatIsOutOfRange)
{
  for (const double depth : {0.4, 9.0})
    for (const double measured :
         measuredWall (depth, noiseOf (NoiseProfile::None)).depth)
      EXPECT_TRUE (std::isinf (measured));
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
  const auto cloud =
      toSurfaceCloud (scanInABox (lidar), origin, CloudLayout::Organized);
  ASSERT_EQ (cloud.width, std::uint32_t (lidar.steps));
  for (std::size_t i = 0; i < cloud.width; i += 100)
    EXPECT_NEAR (std::asin (cloud[i].z / cloud[i].getVector3fMap().norm()),
                 lidar.highest * degree,
                 1e-6);
}
