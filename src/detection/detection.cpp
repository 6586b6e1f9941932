// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Core>

#include "geometry/angles.h"
#include <pcl_ops/detail/detection.h>
#include <pcl_ops/plane_detector_parameters.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace pcl_ops::detail {

std::string
validate (const DetectorInput& input)
{
  if (input.cloud.size == 0)
    return "the input cloud is empty";
  constexpr pcl::index_t max_size = std::numeric_limits<pcl::index_t>::max();
  if (input.cloud.size > static_cast<std::size_t> (max_size))
    return "the input cloud must have fewer than 2^31 points; divide it";
  if (!input.indices)
    return {};
  if (input.indices->empty())
    return "the indices are empty; leave them out to use the whole cloud";
  const Eigen::Map<const Eigen::Array<pcl::index_t, Eigen::Dynamic, 1>> indices (
      input.indices->data(), static_cast<Eigen::Index> (input.indices->size()));
  if (indices.minCoeff() < 0 ||
      static_cast<std::size_t> (indices.maxCoeff()) >= input.cloud.size)
    return "an index lies outside the input cloud";
  return {};
}

void
checkNeighbors (const pcl::Indices& neighbors, std::size_t points)
{
  for (const pcl::index_t neighbor : neighbors)
    if (neighbor < 0 || static_cast<std::size_t> (neighbor) >= points)
      throw std::invalid_argument ("the search returned an index outside the cloud");
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
  const auto isFiniteAndNotNegative = [] (double number) {
    return number >= 0.0 && std::isfinite (number);
  };
  if (!(merging.angle_threshold >= 0.0 && merging.angle_threshold <= max_right_angle))
    return "the merging angle must be between 0 and pi/2 (radians)";
  if (!isFiniteAndNotNegative (merging.distance_threshold.value_or (0.0)))
    return "the merging distance must be a length, or not be given";
  if (!isFiniteAndNotNegative (merging.noise_factor.value_or (0.0)))
    return "the merging noise factor must be 0 or more, or not be given";
  return {};
}

} // namespace

std::string
validate (const PlaneDetectorParameters& parameters)
{
  constexpr double any_valid = 1.0; // if no threshold is given
  const double theta_h = parameters.distance_threshold.value_or (any_valid);
  if (!(theta_h > 0.0 && std::isfinite (theta_h)))
    return "the distance threshold must be a length above 0";
  if (!parameters.up_axis.allFinite() || parameters.up_axis.isZero (0.0f))
    return "the up axis must be a finite vector other than zero";
  if (!(parameters.angle_tolerance >= 0.0 &&
        parameters.angle_tolerance <= max_right_angle))
    return "the angle tolerance must be between 0 and pi/2 (radians)";
  return validate (parameters.merging);
}

} // namespace pcl_ops
