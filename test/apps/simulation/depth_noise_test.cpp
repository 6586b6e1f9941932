// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "simulated_scene.h"

#include <cmath>

using namespace pcl_ops::simulation;

namespace {

DepthImage
measuredWall (double depth, const NoiseParameters& noise)
{
  return measureDepth (wallAt (depth), smallCamera(), noise, seedOfTest());
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

TEST (DepthNoise, ScalesWithItsFactor)
{
  NoiseParameters noise = noiseOf (NoiseProfile::Correlated);
  const double whole = meanSquaredError (measuredWall (3.0, noise), 3.0);
  noise.scale = 0.5;
  const double half = meanSquaredError (measuredWall (3.0, noise), 3.0);
  EXPECT_NEAR (half / whole, 0.25, 1e-6);
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

TEST (DepthNoise, RawErrorsAreIndependent)
{
  const DepthImage image = measuredWall (3.0, noiseOf (NoiseProfile::Raw));
  EXPECT_NEAR (errorCorrelation (image, 3.0, 1), 0.0, 0.05);
}

TEST (DepthNoise, RawDisparityComesInEighthsOfAPixel)
{
  const DepthImage image = measuredWall (3.0, noiseOf (NoiseProfile::Raw));
  for (const double depth : image.depth) {
    const double eighths = 8.0 * 525.0 * 0.075 / depth;
    EXPECT_NEAR (eighths, std::round (eighths), 1e-9);
  }
}

TEST (DepthNoise, FlyingPixelsAreBetweenTheEdgesSidesAndOnNoSurface)
{
  const DepthImage image =
      measureDepth (stepScene (2.0, 4.0), smallCamera(), {}, seedOfTest());
  int flying = 0;
  for (std::size_t i = 0; i < image.depth.size(); ++i) {
    const bool is_between = image.depth[i] > 2.1 && image.depth[i] < 3.85;
    flying += is_between;
    if (is_between) {
      EXPECT_EQ (image.surface[i], no_surface);
    }
  }
  EXPECT_GT (flying, 20);
  EXPECT_LT (flying, 2 * 120);
}

TEST (DepthNoise, NoneHasSharpEdges)
{
  const DepthImage image = measureDepth (
      stepScene (2.0, 4.0), smallCamera(), noiseOf (NoiseProfile::None), seedOfTest());
  for (const double depth : image.depth)
    EXPECT_TRUE (depth == 2.0 || depth == 4.0) << depth;
}

TEST (DepthNoise, LosesWhatIsOutOfRange)
{
  for (const double depth : {0.4, 9.0})
    for (const double measured :
         measuredWall (depth, noiseOf (NoiseProfile::None)).depth)
      EXPECT_TRUE (std::isinf (measured));
}
