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
  // Expected number of drawn points. It is below .18, which the default rate of .03
  // draws on average from a cloud of min_places (6) points.
  constexpr double min_drawn = 0.1;
  return parameters.sampling_rate * static_cast<double> (points) < min_drawn;
}

std::size_t
neighborhoodSizeFor (const OrientedPointSamplingParameters& parameters,
                     std::size_t places)
{
  // As in the paper, a larger k makes normals smoother, and a larger sampling rate
  // finds smaller planes. With the defaults of both parameters the factor is 1.
  constexpr double default_k = 30.0;
  constexpr double default_rate = 0.03;
  // Chosen by hand: ten times the rate gives 0.56 times the neighbors.
  constexpr double exponent = 0.25;
  const double factor = parameters.k / default_k *
                        std::pow (default_rate / parameters.sampling_rate, exponent);
  const std::optional<CloudNoise>& whole = parameters.noise_of_whole;
  const double points_of_cloud = whole ? whole->points : static_cast<double> (places);
  return std::min (places, neighborhoodSize (points_of_cloud, factor));
}

double
minPointsFactor (const OrientedPointSamplingParameters& parameters)
{
  constexpr double default_min_samples = 20.0;
  return parameters.min_samples / default_min_samples;
}

} // namespace pcl_ops::internal
