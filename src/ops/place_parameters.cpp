// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ops/place_parameters.h"

#include "ops/places.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace pcl_ops::internal {

bool
drawsNothing (const OrientedPointSamplingParameters& parameters, std::size_t points)
{
  constexpr double least_drawn = 0.1; // expected number of points
  return parameters.sampling_rate * static_cast<double> (points) < least_drawn;
}

std::size_t
neighborsOf (const OrientedPointSamplingParameters& parameters, std::size_t places)
{
  // As in the paper, a larger k makes normals smoother, and a larger sampling rate
  // finds smaller planes.
  constexpr double usual_k = 30.0;
  constexpr double usual_rate = 0.03;
  constexpr double power = 0.25; // ten times the rate: about half the neighbors
  const double factor =
      parameters.k / usual_k * std::pow (usual_rate / parameters.sampling_rate, power);
  const std::optional<CloudNoise>& whole = parameters.noise_of_whole;
  return std::min (
      places,
      neighborsOfCloud (whole ? whole->points : static_cast<double> (places), factor));
}

double
minPointsFactor (const OrientedPointSamplingParameters& parameters)
{
  constexpr double usual_samples = 20.0;
  return parameters.min_samples / usual_samples;
}

} // namespace pcl_ops::internal
