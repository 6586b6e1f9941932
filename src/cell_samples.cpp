// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cell_samples.h"

namespace pcl_ops {

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

} // namespace pcl_ops
