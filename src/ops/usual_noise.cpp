// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ops/usual_noise.h"

#include "ops/constants.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>

namespace pcl_ops::internal {

namespace {

// Returns the base 2 logarithm, limited to finite values: the density of points that
// are extremely far apart is rounded to 0.
double
log2Of (double density)
{
  constexpr double limit = 300.0; // beyond all single precision values
  return std::clamp (std::log2 (density), -limit, limit);
}

int
octaveOf (double density)
{
  return static_cast<int> (std::floor (log2Of (density)));
}

// Returns the values of an octave and every second value of the adjacent octaves, to
// give these half the weight.
std::vector<float>
valuesAround (const std::map<int, std::vector<float>>& by_octave, int octave)
{
  std::vector<float> values;
  for (int step = -1; step <= 1; ++step)
    if (const auto found = by_octave.find (octave + step); found != by_octave.end())
      for (std::size_t i = 0; i < found->second.size(); i += step == 0 ? 1 : 2)
        values.push_back (found->second[i]);
  return values;
}

} // namespace

float
quantileOf (std::vector<float>& values, double share)
{
  if (values.empty())
    return 0.0F;
  const auto number = static_cast<double> (values.size());
  const auto position =
      std::min (values.size() - 1, static_cast<std::size_t> (share * number));
  const auto quantile = values.begin() + static_cast<std::ptrdiff_t> (position);
  std::nth_element (values.begin(), quantile, values.end());
  return *quantile;
}

void
setUsualNoise (const std::vector<float>& density,
               const std::vector<float>& noise,
               CloudNoise& cloud)
{
  constexpr double half = 0.5;
  std::map<int, std::vector<float>> by_octave;
  for (std::size_t i = 0; i < density.size(); ++i)
    by_octave[octaveOf (density[i])].push_back (noise[i]);
  std::vector<float> all (noise); // quantileOf reorders it
  cloud.usual = quantileOf (all, half);
  cloud.usual_of_octave.clear();
  for (const auto& [octave, values] : by_octave) {
    std::vector<float> nearby = valuesAround (by_octave, octave);
    cloud.usual_of_octave[octave] = std::min<double> (
        quantileOf (nearby, half), place_constants.max_usual_over_cloud * cloud.usual);
  }
}

double
usualNoise (const CloudNoise& cloud, double density)
{
  // The value of an octave belongs to its middle, at octave + 0.5.
  const double position = log2Of (density) - 0.5;
  const int octave = static_cast<int> (std::floor (position));
  const auto lower = cloud.usual_of_octave.find (octave);
  const auto upper = cloud.usual_of_octave.find (octave + 1);
  const auto missing = cloud.usual_of_octave.end();
  if (lower == missing && upper == missing)
    return cloud.usual;
  if (lower == missing)
    return upper->second;
  if (upper == missing)
    return lower->second;
  const double share_of_upper = position - octave;
  return std::pow (lower->second, 1.0 - share_of_upper) *
         std::pow (upper->second, share_of_upper);
}

} // namespace pcl_ops::internal
