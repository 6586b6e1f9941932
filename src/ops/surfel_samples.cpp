// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ops/surfel_samples.h"

#include "base/vectorized.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl_ops::internal {

namespace {

// Whole numbers, combined without a branch, so that the loops below vectorize.
inline int
isInlier (const SurfelSamples& samples,
          std::size_t i,
          float distance,
          const SurfelBand& band)
{
  const float cosine = band.plane.nx * samples.normals.x[i] +
                       band.plane.ny * samples.normals.y[i] +
                       band.plane.nz * samples.normals.z[i];
  const int is_near = distance < samples.bands[i];
  const int is_parallel = std::abs (cosine) > band.smallest_cosine;
  return is_near & is_parallel;
}

PCL_OPS_VECTORIZED
Vote
countOn (const SurfelSamples& samples, const SurfelBand& band)
{
  const std::int32_t* const weights = samples.weights.data();
  std::int32_t weight = 0, inliers = 0;
  forDistances (band.plane, samples.centroids, [&] (std::size_t i, float distance) {
    const std::int32_t inlier = -isInlier (samples, i, distance, band);
    weight += inlier & weights[i];
    inliers -= inlier;
  });
  return {weight, inliers, samples.size()};
}

PCL_OPS_VECTORIZED
Indices
listOn (const SurfelSamples& samples, const SurfelBand& band)
{
  constexpr std::size_t batch = 64;
  std::array<std::uint8_t, batch> is_on;
  Indices voxels;
  for (std::size_t begin = 0; begin < samples.size(); begin += batch) {
    const std::size_t end = std::min (begin + batch, samples.size());
    int any = 0;
    forDistances (
        band.plane, samples.centroids, begin, end, [&] (std::size_t i, float distance) {
          const int inlier = isInlier (samples, i, distance, band);
          is_on[i - begin] = static_cast<std::uint8_t> (inlier);
          any |= inlier;
        });
    if (!any)
      continue;
    for (std::size_t i = begin; i < end; ++i)
      if (is_on[i - begin])
        voxels.push_back (samples.voxels[i]);
  }
  return voxels;
}

} // namespace

Vote
voteOf (const SurfelSamples& samples, const SurfelBand& band)
{
  return countOn (samples, band);
}

Indices
surfelsOn (const SurfelSamples& samples, const SurfelBand& band)
{
  return listOn (samples, band);
}

void
keepOnly (const std::vector<char>& is_kept, SurfelSamples& samples)
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
    visit (samples.voxels);
  };
  for (std::size_t i = 0; i < samples.size(); ++i) {
    forAll ([kept, i] (auto& values) { values[kept] = values[i]; });
    kept += is_kept[samples.voxels[i]] != 0;
  }
  forAll ([kept] (auto& values) { values.resize (kept); });
}

} // namespace pcl_ops::internal
