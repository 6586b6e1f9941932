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
#include <utility>

namespace pcl_ops {

namespace internal {
namespace {

// Returns the given sampling, or what Sampling::Automatic stands for.
Sampling
usedSampling (const OrientedPointSamplingParameters& parameters)
{
  if (parameters.sampling != Sampling::Automatic)
    return parameters.sampling;
  return parameters.surfels.voxel_size ? Sampling::Surfels : Sampling::Neighborhoods;
}

// Calls the detector of the used sampling: as in the paper, on voxels, or on
// neighborhoods, the default.
LabeledPlanes
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
  OrientedPointSamplingParameters with_observer_of_points = parameters;
  with_observer_of_points.on_stage =
      observerOfPoints (parameters.on_stage, points, input.cloud.size);
  return detectOnPlaces (points, with_observer_of_points, durations);
}

} // namespace
} // namespace internal

detail::Detection
detail::detect (const DetectorInput& input,
                const OrientedPointSamplingParameters& parameters)
{
  using namespace internal;
  // The local origin is a multiple of the coarsest voxel's edge, so that voxels begin
  // at multiples of their edge in the frame of the cloud, too.
  Detection found = detectInFinitePoints (
      input,
      parameters,
      [&] (const Points& points, StageDurations& durations) {
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
  const internal::Points points = internal::distinctPoints (cloud, parameters.threads);
  // Points that are not finite, and duplicates if there are many, do not count. Their
  // share in the whole cloud is taken to be that in cloud.
  const double share_that_counts =
      cloud.size > 0
          ? static_cast<double> (points.size()) / static_cast<double> (cloud.size)
          : 1.0;
  const double counted_of_whole =
      std::round (share_that_counts * static_cast<double> (points_of_whole));
  return internal::noiseOfCloud (
      points, parameters, static_cast<std::size_t> (counted_of_whole));
}

// The values of Table III of the paper.
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
isFiniteAndAtLeast (double least, double value)
{
  return value >= least && std::isfinite (value);
}

// Whether all members have values that measureNoise can give them.
bool
isValid (const CloudNoise& noise)
{
  const auto isFactor = [] (double value) { return isFiniteAndAtLeast (1.0, value); };
  const auto isNoiseOfOctave = [] (const std::pair<const int, double>& usual) {
    return isFiniteAndAtLeast (0.0, usual.second);
  };
  return isFiniteAndAtLeast (1.0, noise.points) && isFactor (noise.common_errors) &&
         isFiniteAndAtLeast (0.0, noise.usual) &&
         std::all_of (noise.growth.begin(), noise.growth.end(), isFactor) &&
         std::all_of (noise.usual_of_octave.begin(),
                      noise.usual_of_octave.end(),
                      isNoiseOfOctave);
}

// Whether a length [m] can be the edge of voxels: the edge and its inverse are used in
// single precision, where very small and very large values become 0 or infinite.
bool
isVoxelSize (double edge)
{
  return edge > 0.0 && std::isnormal (static_cast<float> (edge)) &&
         std::isnormal (static_cast<float> (1.0 / edge));
}

std::string
validate (const OrientedPointSamplingParameters::Surfels& surfels)
{
  // The voxels of resolution 10 have 2^10 times the finest edge: no larger ones have a
  // border at coordinate 0 (key_offset of morton_code.h).
  constexpr int max_resolutions = 10;
  if (surfels.voxel_size && !isVoxelSize (*surfels.voxel_size))
    return "the voxel size must be a length above 0, or not be given";
  if (surfels.resolutions < 1 || surfels.resolutions > max_resolutions)
    return "the number of resolutions must be between 1 and 10";
  if (!isFiniteAndAtLeast (0.0, surfels.min_average_voxels))
    return "min_average_voxels must be 0 or more";
  if (!isFiniteAndAtLeast (0.0, surfels.noise_factor))
    return "the noise factor of surfels must be 0 or more";
  if (!(surfels.angle_threshold >= 0.0 &&
        surfels.angle_threshold <= internal::max_right_angle))
    return "the angle threshold of surfels must be between 0 and pi/2 (radians)";
  if (!isFiniteAndAtLeast (0.0, surfels.sure_thickness) ||
      !isFiniteAndAtLeast (0.0, surfels.max_thickness))
    return "the thickness of surfels must be 0 or more";
  if (!isFiniteAndAtLeast (0.0, surfels.absorption_noise_factor))
    return "the noise factor of absorption must be 0 or more";
  if (!isFiniteAndAtLeast (0.0, surfels.assignment_noise_factor))
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
  if (parameters.noise_of_whole && !isValid (*parameters.noise_of_whole))
    return "the noise of the whole must come from measureNoise of enough points";
  if (parameters.sampling == Sampling::Points && !parameters.distance_threshold)
    return "the distance threshold must be a length above 0";
  const std::string problem = validate (parameters.surfels);
  return problem.empty()
             ? validate (static_cast<const PlaneDetectorParameters&> (parameters))
             : problem;
}

} // namespace pcl_ops
