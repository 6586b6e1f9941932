// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "leaves/expected_noise.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace pcl_ops::internal {

namespace {

// 2^100: no noise is as large.
constexpr float unknown_noise = 100.0f;
// Density of the lowest class: 2^-80 points on the square of a finest cell.
constexpr double lowest_density = -80.0;

double
classOf (double density, int classes)
{
  return std::clamp (density - lowest_density, 0.0, classes - 1.001);
}

} // namespace

float
ExpectedNoise::Curve::at (double level) const
{
  // log2 of the growth for each doubling beyond the largest size that tells.
  constexpr float growth_beyond = 0.3785f; // a factor of 1.3
  if (!isKnown())
    return unknown_noise;
  if (level <= finest)
    return noise[finest];
  if (level >= coarsest)
    return noise[coarsest] + growth_beyond * static_cast<float> (level - coarsest);
  const auto below = static_cast<std::size_t> (level);
  const auto weight = static_cast<float> (level - static_cast<double> (below));
  return noise[below] + weight * (noise[below + 1] - noise[below]);
}

ExpectedNoise::Curve
ExpectedNoise::curveOf (std::array<std::vector<float>, top_level + 1>& noise_of_level,
                        double cell)
{
  constexpr std::size_t min_cells = 30;
  constexpr double flattest_share = 0.1;
  constexpr float structure_growth = 1.0f; // log2: noise does not double with the size
  constexpr double rounding = 1e-3;        // of the edge of a cell
  Curve curve;
  for (int level = 0; level <= top_level; ++level) {
    std::vector<float>& noise = noise_of_level[level];
    if (noise.size() < min_cells && !curve.isKnown())
      continue;
    if (noise.size() < min_cells)
      break;
    const auto at =
        noise.begin() + static_cast<std::ptrdiff_t> (
                            flattest_share * static_cast<double> (noise.size()));
    std::nth_element (noise.begin(), at, noise.end());
    // On the steps of a quantized depth: nothing is known of so small a scale.
    const bool is_exact = *at < rounding * std::ldexp (cell, level);
    if (is_exact && !curve.isKnown())
      continue;
    curve.noise[level] = is_exact ? curve.noise[level - 1] : std::log2 (*at);
    if (!curve.isKnown())
      curve.finest = level;
    curve.coarsest = level;
  }
  while (curve.coarsest > curve.finest &&
         curve.noise[curve.coarsest] - curve.noise[curve.coarsest - 1] >
             structure_growth)
    --curve.coarsest;
  return curve;
}

ExpectedNoise::ExpectedNoise (const std::vector<CellScatter>& cells, double cell_size)
: curves_ (classes)
{
  std::map<int, std::array<std::vector<float>, top_level + 1>> noise_of_class;
  for (const CellScatter& cell : cells) {
    if (!cell.is_wide)
      continue;
    const double density = densityOf (cell.count, cell.level);
    const auto of_class = static_cast<int> (classOf (density, classes));
    noise_of_class[of_class][cell.level].push_back (cell.noise);
  }
  for (auto& [of_class, noise_of_level] : noise_of_class)
    curves_[of_class] = curveOf (noise_of_level, cell_size);
  fillGaps();
}

int
ExpectedNoise::nearestKnown (const std::vector<Curve>& curves, int own)
{
  for (int distance = 0; distance < classes; ++distance)
    for (const int other : {own - distance, own + distance})
      if (other >= 0 && other < classes && curves[other].isKnown())
        return other;
  return own;
}

void
ExpectedNoise::fillGaps()
{
  const std::vector<Curve> known = curves_;
  for (int own = 0; own < classes; ++own)
    curves_[own] = known[nearestKnown (known, own)];
  for (Curve& curve : curves_) {
    curve.lowest = unknown_noise;
    for (int level = curve.finest; curve.isKnown() && level <= curve.coarsest; ++level)
      curve.lowest = std::min (curve.lowest, curve.noise[level]);
  }
}

double
ExpectedNoise::of (double density, double points) const
{
  // The size of the cell that holds so many points at this density.
  const double level = 0.5 * (std::log2 (points) - density);
  // Classes are known in their middles.
  const double place = classOf (density - 0.5, classes);
  const auto below = static_cast<std::size_t> (place);
  const double weight = place - static_cast<double> (below);
  return std::exp2 ((1.0 - weight) * curves_[below].at (level) +
                    weight * curves_[below + 1].at (level));
}

bool
ExpectedNoise::isKnown (double noise)
{
  return noise < std::exp2 (0.5 * unknown_noise);
}

double
ExpectedNoise::lowest (double density) const
{
  constexpr double rounding = 0.999;
  const double place = classOf (density - 0.5, classes);
  const auto below = static_cast<std::size_t> (place);
  const double weight = place - static_cast<double> (below);
  return rounding * std::exp2 ((1.0 - weight) * curves_[below].lowest +
                               weight * curves_[below + 1].lowest);
}

bool
ExpectedNoise::isNoise (double density, int level) const
{
  const auto own = static_cast<std::size_t> (classOf (density, classes));
  return level <= curves_[own].coarsest;
}

} // namespace pcl_ops::internal
