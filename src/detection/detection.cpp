// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/angles.h"
#include <pcl_ops/detail/detection.h>
#include <pcl_ops/plane_detector_parameters.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <type_traits>

namespace pcl_ops::detail {
namespace {

// Negative ones are the largest. A loop without a way out is vectorized.
std::size_t
largestOf (const pcl::Indices& indices)
{
  using Number = std::make_unsigned_t<pcl::index_t>;
  Number largest = 0;
  for (const pcl::index_t index : indices)
    largest = std::max (largest, static_cast<Number> (index));
  return largest;
}

} // namespace

std::string
validate (const DetectorInput& input)
{
  if (input.cloud.size == 0)
    return "the input cloud is empty";
  if (!input.indices)
    return {};
  if (input.indices->empty())
    return "the indices are empty; leave them out to use the whole cloud";
  if (largestOf (*input.indices) >= input.cloud.size)
    return "an index lies outside the input cloud";
  return {};
}

void
throwOn (const std::string& problem)
{
  if (!problem.empty())
    throw std::invalid_argument (problem);
}

} // namespace pcl_ops::detail

namespace pcl_ops {
using namespace internal;
namespace {

std::string
validate (const MergingParameters& merging)
{
  const auto isSize = [] (double number) {
    return number >= 0.0 && std::isfinite (number);
  };
  if (!(merging.angle_threshold >= 0.0 && merging.angle_threshold <= right_angle))
    return "the merging angle must be between 0 and pi/2 (radians)";
  if (!isSize (merging.distance_threshold.value_or (0.0)))
    return "the merging distance must be a length, or not be given";
  if (!isSize (merging.noise_factor.value_or (0.0)))
    return "the merging noise factor must be 0 or more, or not be given";
  return {};
}

} // namespace

std::string
validate (const PlaneDetectorParameters& parameters)
{
  const double theta_h = parameters.distance_threshold.value_or (1.0);
  if (!(theta_h > 0.0 && std::isfinite (theta_h)))
    return "the distance threshold must be a length above 0";
  if (!parameters.up_axis.allFinite() || parameters.up_axis.isZero (0.0f))
    return "the up axis must be a finite vector other than zero";
  if (!(parameters.angle_tolerance >= 0.0 && parameters.angle_tolerance <= right_angle))
    return "the angle tolerance must be between 0 and pi/2 (radians)";
  return validate (parameters.merging);
}

} // namespace pcl_ops
