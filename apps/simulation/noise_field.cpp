// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "noise_field.h"

#include "draws.h"

#include <cmath>
#include <cstddef>

namespace pcl_ops::simulation {

namespace {

/** \brief A Gaussian whose squares sum to 1, so that filtering white noise with it
 * keeps the variance. */
std::vector<double>
variancePreservingKernel (int radius, double sigma)
{
  std::vector<double> kernel;
  double energy = 0.0;
  for (int i = -radius; i <= radius; ++i) {
    kernel.push_back (std::exp (-0.5 * i * i / (sigma * sigma)));
    energy += kernel.back() * kernel.back();
  }
  for (double& weight : kernel)
    weight /= std::sqrt (energy);
  return kernel;
}

/** \brief Filters along the rows and transposes; the rows get shorter by the kernel. */
std::vector<double>
filterRowsAndTranspose (const std::vector<double>& field,
                        std::size_t width,
                        const std::vector<double>& kernel)
{
  const std::size_t height = field.size() / width;
  const std::size_t filtered_width = width - kernel.size() + 1;
  std::vector<double> filtered (filtered_width * height);
  for (std::size_t row = 0; row < height; ++row)
    for (std::size_t column = 0; column < filtered_width; ++column) {
      const double* const window = &field[row * width + column];
      double sum = 0.0;
      for (std::size_t i = 0; i < kernel.size(); ++i)
        sum += kernel[i] * window[i];
      filtered[column * height + row] = sum;
    }
  return filtered;
}

} // namespace

std::vector<double>
drawWhiteField (int width, int height, internal::RandomGenerator& generator)
{
  std::vector<double> field (std::size_t (width) * height);
  for (double& value : field)
    value = drawGaussian (generator);
  return field;
}

std::vector<double>
drawSmoothField (int width,
                 int height,
                 double smoothing,
                 internal::RandomGenerator& generator)
{
  const int radius = int (std::ceil (3.0 * smoothing));
  const std::vector<double> kernel = variancePreservingKernel (radius, smoothing);
  const int wide = width + 2 * radius;
  const int high = height + 2 * radius;
  const std::vector<double> white = drawWhiteField (wide, high, generator);
  const std::vector<double> columns = filterRowsAndTranspose (white, wide, kernel);
  return filterRowsAndTranspose (columns, high, kernel);
}

} // namespace pcl_ops::simulation
