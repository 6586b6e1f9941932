// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/angles.h"
#include "ops/detect_on_places.h"
#include "ops/stage_reports.h"
#include "paper/detect_as_in_paper.h"
#include "voxels/detect_on_voxels.h"
#include <pcl_ops/oriented_point_sampling.h>

#include <algorithm>
#include <cmath>

namespace pcl_ops {

namespace internal {
namespace {

// The sampling that Sampling::Automatic stands for, or the one that is given.
Sampling
usedSampling (const OrientedPointSamplingParameters& parameters)
{
  if (parameters.sampling != Sampling::Automatic)
    return parameters.sampling;
  return parameters.surfels.voxel_size ? Sampling::Surfels : Sampling::Neighborhoods;
}

// Calls the engine of the sampling: one detects as in the paper, one on voxels, and the
// default on neighborhoods.
LabelledPlanes
detectBySampling (const DetectorInput& input,
                  const OrientedPointSamplingParameters& parameters,
                  const Points& points,
                  StageDurations& durations)
{
  const Sampling sampling = usedSampling (parameters);
  if (sampling == Sampling::Points)
    return detectAsInPaper (input, points, parameters, durations);
  if (sampling == Sampling::Surfels)
    return detectOnVoxels (points, parameters, durations);
  OrientedPointSamplingParameters of_points = parameters;
  of_points.on_stage = observerOfPoints (parameters.on_stage, points, input.cloud.size);
  return detectOnPlaces (points, of_points, durations);
}

} // namespace
} // namespace internal

detail::Detection
detail::detect (const DetectorInput& input,
                const OrientedPointSamplingParameters& parameters)
{
  using namespace internal;
  Detection found = detectInFinitePoints (
      input,
      parameters,
      [&] (const auto& points, auto& durations) {
        return detectBySampling (input, parameters, points, durations);
      },
      coarsestVoxel (parameters.surfels));
  if (usedSampling (parameters) == Sampling::Neighborhoods)
    reportLabels (parameters.on_stage, found.planes, input.cloud.size);
  return found;
}

CloudNoise
measureNoise (const CloudView& cloud,
              const OrientedPointSamplingParameters& parameters,
              std::size_t points_of_whole)
{
  detail::throwOn (validate (parameters));
  return internal::noiseOfCloud (internal::distinctPoints (cloud, parameters.threads),
                                 parameters,
                                 points_of_whole);
}

OrientedPointSamplingParameters
OrientedPointSamplingParameters::paper()
{
  OrientedPointSamplingParameters parameters;
  parameters.sampling = Sampling::Points;
  parameters.sampling_rate = 0.03;
  parameters.k = 30;
  parameters.paper_only.normal_sigma.reset();
  parameters.distance_threshold = 0.05;
  parameters.min_samples = 20;
  parameters.paper_only.probability = 0.99;
  parameters.paper_only.strategy = PaperParameters::Strategy::DivideThenDetect;
  parameters.paper_only.verification = PaperParameters::Verification::Samples;
  parameters.paper_only.local_optimization = false;
  return parameters;
}

namespace {

bool
isAtLeastZero (double value)
{
  return value >= 0.0 && std::isfinite (value);
}

bool
isNoise (const CloudNoise& noise)
{
  const auto is_growth = [] (double value) {
    return value >= 1.0 && std::isfinite (value);
  };
  return noise.points >= 1.0 && std::isfinite (noise.points) &&
         is_growth (noise.common_errors) && isAtLeastZero (noise.usual) &&
         std::all_of (noise.growth.begin(), noise.growth.end(), is_growth) &&
         std::all_of (
             noise.usual_of_octave.begin(),
             noise.usual_of_octave.end(),
             [] (const auto& octave) { return isAtLeastZero (octave.second); });
}

// A voxel's edge and its inverse are used in single precision.
bool
isVoxelSize (double size)
{
  return size > 0.0 && std::isnormal (static_cast<float> (size)) &&
         std::isnormal (static_cast<float> (1.0 / size));
}

std::string
validate (const OrientedPointSamplingParameters::Surfels& surfels)
{
  constexpr int max_resolutions = 10;
  if (surfels.voxel_size && !isVoxelSize (*surfels.voxel_size))
    return "the voxel size must be a length above 0, or not be given";
  if (surfels.resolutions < 1 || surfels.resolutions > max_resolutions)
    return "the number of resolutions must be between 1 and 10";
  if (!isAtLeastZero (surfels.min_average_voxels))
    return "min_average_voxels must be 0 or more";
  if (!isAtLeastZero (surfels.noise_factor))
    return "the noise factor of surfels must be 0 or more";
  if (!(surfels.angle_threshold >= 0.0 &&
        surfels.angle_threshold <= internal::right_angle))
    return "the angle threshold of surfels must be between 0 and pi/2 (radians)";
  if (!isAtLeastZero (surfels.sure_thickness) || !isAtLeastZero (surfels.max_thickness))
    return "the thickness of surfels must be 0 or more";
  if (!isAtLeastZero (surfels.absorption_noise_factor))
    return "the noise factor of absorption must be 0 or more";
  if (!isAtLeastZero (surfels.assignment_noise_factor))
    return "the noise factor of assignment must be 0 or more";
  return {};
}

} // namespace

std::string
validate (const OrientedPointSamplingParameters& parameters)
{
  if (!(parameters.sampling_rate > 0.0 && parameters.sampling_rate <= 1.0))
    return "the sampling rate must be above 0 and at most 1";
  if (parameters.k < 2)
    return "k must be 2 or more: a normal needs two neighbors";
  if (parameters.paper_only.normal_sigma &&
      !(*parameters.paper_only.normal_sigma > 0.0 &&
        std::isfinite (*parameters.paper_only.normal_sigma)))
    return "the sigma of the normals must be a length above 0, or not be given";
  if (!(parameters.paper_only.probability > 0.0 &&
        parameters.paper_only.probability < 1.0))
    return "the probability must lie between 0 and 1, both excluded";
  if (parameters.noise_of_whole && !isNoise (*parameters.noise_of_whole))
    return "the noise of the whole must come from measureNoise of enough points";
  if (parameters.sampling == Sampling::Points && !parameters.distance_threshold)
    return "the distance threshold must be a length above 0";
  const std::string problem = validate (parameters.surfels);
  return problem.empty()
             ? validate (static_cast<const PlaneDetectorParameters&> (parameters))
             : problem;
}

} // namespace pcl_ops
