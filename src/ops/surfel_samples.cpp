// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cell_samples.h"

#include "vectorized.h"

#include <algorithm>
#include <array>

namespace pcl_ops {

PCL_OPS_VECTORIZED
Support
supportOf (const CellSamples& samples, const SinglePlane& plane)
{
  const auto size = static_cast<std::int32_t> (samples.size());
  const float* const x = samples.centroids.x.data();
  const float* const y = samples.centroids.y.data();
  const float* const z = samples.centroids.z.data();
  const float* const nx = samples.normals.x.data();
  const float* const ny = samples.normals.y.data();
  const float* const nz = samples.normals.z.data();
  const float* const bands = samples.bands.data();
  const std::int32_t* const weights = samples.weights.data();
  Support support;
  for (std::int32_t i = 0; i < size; ++i) {
    const std::int32_t inlier =
        isInlier (plane, x[i], y[i], z[i], nx[i], ny[i], nz[i], bands[i]) ? -1 : 0;
    support.weight += inlier & weights[i];
    support.cells -= inlier;
  }
  return support;
}

PCL_OPS_VECTORIZED
Positions
cellsOn (const CellSamples& samples, const SinglePlane& plane)
{
  constexpr std::size_t batch = 64;
  std::array<std::uint8_t, batch> is_on;
  Positions cells;
  for (std::size_t begin = 0; begin < samples.size(); begin += batch) {
    const std::size_t number = std::min (batch, samples.size() - begin);
    int any = 0;
    for (std::size_t i = 0; i < number; ++i) {
      const std::size_t s = begin + i;
      is_on[i] = isInlier (plane,
                           samples.centroids.x[s],
                           samples.centroids.y[s],
                           samples.centroids.z[s],
                           samples.normals.x[s],
                           samples.normals.y[s],
                           samples.normals.z[s],
                           samples.bands[s]);
      any |= is_on[i];
    }
    if (!any)
      continue;
    for (std::size_t i = 0; i < number; ++i)
      if (is_on[i])
        cells.push_back (samples.cells[begin + i]);
  }
  return cells;
}

void
keepOnly (const std::vector<char>& is_kept, CellSamples& samples)
{
  std::size_t kept = 0;
  const auto forAll = [&samples] (auto&& visit) {
    for (std::vector<float>* values : {&samples.centroids.x,
                                       &samples.centroids.y,
                                       &samples.centroids.z,
                                       &samples.normals.x,
                                       &samples.normals.y,
                                       &samples.normals.z,
                                       &samples.bands})
      visit (*values);
    visit (samples.weights);
    visit (samples.cells);
  };
  for (std::size_t i = 0; i < samples.size(); ++i) {
    forAll ([kept, i] (auto& values) { values[kept] = values[i]; });
    kept += is_kept[samples.cells[i]] != 0;
  }
  forAll ([kept] (auto& values) { values.resize (kept); });
}

} // namespace pcl_ops
