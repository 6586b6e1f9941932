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

constexpr double half = 0.5; // the share of values below their median

// Returns the base 2 logarithm of a density [1/m^2], limited to finite values: the
// density of points that are extremely far apart is rounded to 0.
double
log2Of (double density)
{
  constexpr double limit = 300.0; // single precision values have less than 2^128
  return std::clamp (std::log2 (density), -limit, limit);
}

int
octaveOf (double density)
{
  return static_cast<int> (std::floor (log2Of (density)));
}

// Returns the values of an octave and every second value of both adjacent octaves, to
// give these half the weight.
std::vector<float>
valuesAround (const std::map<int, std::vector<float>>& by_octave, int octave)
{
  std::vector<float> values;
  for (const int nearby : {octave - 1, octave, octave + 1})
    if (const auto found = by_octave.find (nearby); found != by_octave.end()) {
      const std::vector<float>& values_of_octave = found->second;
      const std::size_t stride = nearby == octave ? 1 : 2;
      for (std::size_t i = 0; i < values_of_octave.size(); i += stride)
        values.push_back (values_of_octave[i]);
    }
  return values;
}

} // namespace

float
quantileOf (std::vector<float>& values, double share)
{
  if (values.empty())
    return 0.0F;
  const auto count = static_cast<double> (values.size());
  const auto index =
      std::min (values.size() - 1, static_cast<std::size_t> (share * count));
  const auto quantile = values.begin() + static_cast<std::ptrdiff_t> (index);
  std::nth_element (values.begin(), quantile, values.end());
  return *quantile;
}

void
setUsualNoise (const std::vector<float>& density,
               const std::vector<float>& noise,
               CloudNoise& cloud)
{
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
  // The value of octave n belongs to the middle of the octave, at log2 = n + 0.5.
  const double middles_below = log2Of (density) - 0.5;
  const int lower_octave = static_cast<int> (std::floor (middles_below));
  const auto lower = cloud.usual_of_octave.find (lower_octave);
  const auto upper = cloud.usual_of_octave.find (lower_octave + 1);
  const auto missing = cloud.usual_of_octave.end();
  if (lower == missing && upper == missing)
    return cloud.usual;
  if (lower == missing)
    return upper->second;
  if (upper == missing)
    return lower->second;
  // A geometric mean, weighted by how near both middles are.
  const double share_of_upper = middles_below - lower_octave;
  return std::pow (lower->second, 1.0 - share_of_upper) *
         std::pow (upper->second, share_of_upper);
}

} // namespace pcl_ops::internal
