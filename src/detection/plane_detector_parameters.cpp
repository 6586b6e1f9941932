// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/angles.h"
#include <pcl_ops/plane_detector_parameters.h>

#include <cmath>

namespace pcl_ops {

using namespace internal;

namespace {

std::string
validate (const MergingParameters& merging)
{
  if (!(merging.angle_threshold >= 0.0 && merging.angle_threshold <= right_angle))
    return "the merging angle must be between 0 and pi/2 (radians)";
  if (merging.distance_threshold && !(*merging.distance_threshold >= 0.0 &&
                                      std::isfinite (*merging.distance_threshold)))
    return "the merging distance must be a length, or not be given";
  if (merging.noise_factor &&
      !(*merging.noise_factor >= 0.0 && std::isfinite (*merging.noise_factor)))
    return "the merging noise factor must be 0 or more, or not be given";
  return {};
}

} // namespace

std::string
validate (const PlaneDetectorParameters& parameters)
{
  if (parameters.distance_threshold &&
      !(*parameters.distance_threshold > 0.0 &&
        std::isfinite (*parameters.distance_threshold)))
    return "the distance threshold must be a length above 0";
  if (!parameters.up_axis.allFinite() || parameters.up_axis.isZero (0.0f))
    return "the up axis must be a finite vector other than zero";
  if (!(parameters.angle_tolerance >= 0.0 && parameters.angle_tolerance <= right_angle))
    return "the angle tolerance must be between 0 and pi/2 (radians)";
  return validate (parameters.merging);
}

} // namespace pcl_ops
