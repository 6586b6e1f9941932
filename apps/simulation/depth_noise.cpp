// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "depth_noise.h"

#include "draws.h"
#include "noise_field.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace pcl_ops::simulation {

namespace {

constexpr double no_reading = std::numeric_limits<double>::infinity();

/** \brief Distance between a Kinect's projector and camera [m] (Khoshelham & Elberink,
 * "Accuracy and Resolution of Kinect Depth Data", Sensors 2012). */
constexpr double baseline = 0.075;

/** \brief Steps of disparity per pixel (same source). */
constexpr double disparity_steps = 8.0;

/** \brief Neighbouring depths that differ by more, relative to the depth, are an edge.
 */
constexpr double edge_ratio = 0.05;
constexpr double flying_fraction = 0.3;
constexpr double lost_fraction = 0.2;

std::vector<double>
drawField (const DepthCamera& camera,
           const NoiseParameters& noise,
           internal::RandomGenerator& generator)
{
  return noise.profile == NoiseProfile::Correlated
             ? drawSmoothField (camera.width, camera.height, noise.smoothing, generator)
             : drawWhiteField (camera.width, camera.height, generator);
}

PixelOffsets
drawLateralJitter (const DepthCamera& camera,
                   const NoiseParameters& noise,
                   internal::RandomGenerator& generator)
{
  PixelOffsets offsets{drawField (camera, noise, generator),
                       drawField (camera, noise, generator)};
  for (auto* axis : {&offsets.column, &offsets.row})
    for (double& offset : *axis)
      offset *= noise.scale * noise.lateral_sigma;
  return offsets;
}

/** \brief The depth of a neighbour on the other side of a depth edge, if there is one.
 */
std::optional<double>
depthAcrossEdge (const DepthImage& image, int column, int row)
{
  const auto depth_at = [&image] (int c, int r) {
    return image.depth[std::size_t (r) * image.width + c];
  };
  const double depth = depth_at (column, row);
  for (const auto& [c, r] : {std::pair (column + 1, row),
                             std::pair (column - 1, row),
                             std::pair (column, row + 1),
                             std::pair (column, row - 1)})
    if (c >= 0 && c < image.width && r >= 0 && r < image.height) {
      const double other = depth_at (c, r);
      if (std::abs (other - depth) > edge_ratio * std::min (other, depth))
        return other;
    }
  return std::nullopt;
}

void
disturbEdges (DepthImage& image,
              const NoiseParameters& noise,
              internal::RandomGenerator& generator)
{
  const DepthImage exact = image;
  const double strength = std::min (1.0, noise.scale);
  for (int row = 0; row < image.height; ++row)
    for (int column = 0; column < image.width; ++column) {
      const auto other = depthAcrossEdge (exact, column, row);
      if (!other)
        continue;
      const std::size_t i = std::size_t (row) * image.width + column;
      const double chance = internal::drawUnit (generator) / strength;
      if (chance < flying_fraction) {
        image.depth[i] += drawBetween (generator, 0.1, 0.9) * (*other - image.depth[i]);
        image.surface[i] = no_surface;
      }
      else if (chance < flying_fraction + lost_fraction)
        image.depth[i] = no_reading;
    }
}

void
addAxialNoise (DepthImage& image,
               const DepthCamera& camera,
               const NoiseParameters& noise,
               internal::RandomGenerator& generator)
{
  const std::vector<double> field = drawField (camera, noise, generator);
  for (std::size_t i = 0; i < field.size(); ++i)
    image.depth[i] += noise.scale * axialSigma (image.depth[i]) * field[i];
}

/** \brief The steps are those of the Kinect's own image also in a smaller one. */
void
quantizeDisparity (DepthImage& image)
{
  constexpr double steps_times_depth = disparity_steps * kinect_focal_length * baseline;
  for (double& depth : image.depth)
    if (depth > 0.0)
      depth = steps_times_depth / std::round (steps_times_depth / depth);
}

void
dropOutOfRange (DepthImage& image, const DepthCamera& camera)
{
  for (double& depth : image.depth)
    if (!(depth >= camera.nearest && depth <= camera.farthest))
      depth = no_reading;
}

} // namespace

double
axialSigma (double depth)
{
  return 0.0012 + 0.0019 * (depth - 0.4) * (depth - 0.4);
}

DepthImage
measureDepth (const Scene& scene,
              const DepthCamera& camera,
              const NoiseParameters& noise,
              std::uint32_t seed)
{
  internal::RandomGenerator generator = makeGenerator (seed, Purpose::DepthNoise);
  PixelOffsets jitter;
  if (!noise.isNone())
    jitter = drawLateralJitter (camera, noise, generator);
  DepthImage image = castDepthImage (scene, camera, jitter);
  if (!noise.isNone()) {
    disturbEdges (image, noise, generator);
    addAxialNoise (image, camera, noise, generator);
    if (noise.profile == NoiseProfile::Raw)
      quantizeDisparity (image);
  }
  dropOutOfRange (image, camera);
  return image;
}

} // namespace pcl_ops::simulation
