// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "leaves/plane_layers.h"

#include "leaves/leaf_labels.h"

#include <algorithm>
#include <cmath>

namespace pcl_ops::internal {

namespace {

// The signed distance that parts two layers, if there are two.
std::optional<double>
thresholdOf (std::vector<double>& distances, double min_noise, double min_apart)
{
  constexpr std::size_t min_distances = 50;
  // 0.64 of the variance of an even distribution, .75 of two normal ones that touch.
  constexpr double min_explained = 0.88;
  if (distances.size() < min_distances)
    return std::nullopt;
  std::sort (distances.begin(), distances.end());
  double sum = 0.0;
  double squares = 0.0;
  for (const double distance : distances) {
    sum += distance;
    squares += distance * distance;
  }
  const auto all = static_cast<double> (distances.size());
  const double total = squares - sum * sum / all;
  double best = 0.0;
  double best_apart = 0.0;
  double sum_below = 0.0;
  std::size_t first_above = 0;
  for (std::size_t i = 1; i < distances.size(); ++i) {
    sum_below += distances[i - 1];
    const auto below = static_cast<double> (i);
    const double apart = sum_below / below - (sum - sum_below) / (all - below);
    const double explained = below * (all - below) / all * apart * apart;
    if (explained > best) {
      best = explained;
      best_apart = std::abs (apart);
      first_above = i;
    }
  }
  // Two steps of a quantized coordinate are no layers: they are two noises apart.
  constexpr double noises_apart = 2.2;
  if (best <= min_explained * total || best_apart < noises_apart * min_noise ||
      best_apart < min_apart)
    return std::nullopt;
  return 0.5 * (distances[first_above - 1] + distances[first_above]);
}

/** \brief Some signed distances of a plane's points, spread evenly over them [m]. */
struct SampledDistances {
  std::vector<double> distances;
  double sum_of_min_noise = 0.0; // of the leaves they are in
  std::size_t seen = 0;
};

double
minNoiseOf (const SampledDistances& sample)
{
  return sample.sum_of_min_noise /
         static_cast<double> (std::max<std::size_t> (1, sample.distances.size()));
}

std::vector<SampledDistances>
sampleDistances (const LeafCloud& cloud, const LeafPlanes& planes, const Labels& labels)
{
  constexpr std::size_t wanted = 500;
  const std::vector<std::size_t> counts = countLabels (labels, planes.planes.size());
  std::vector<SampledDistances> samples (planes.planes.size());
  for (std::size_t i = 0; i < cloud.size(); ++i)
    for (std::uint32_t p = cloud.leaves[i].begin; p < cloud.leaves[i].end; ++p) {
      const std::int32_t plane = labels[p];
      if (plane == no_plane)
        continue;
      SampledDistances& sample = samples[plane];
      if (sample.seen % (counts[plane] / wanted + 1) == 0) {
        sample.distances.push_back (planes.planes[plane].distance ((*cloud.points)[p]));
        sample.sum_of_min_noise += cloud.min_noise[i];
      }
      ++sample.seen;
    }
  return samples;
}

} // namespace

void
splitLayers (const LeafCloud& cloud,
             const LeafPlanes& planes,
             std::optional<double> distance_threshold,
             Labels& labels,
             std::vector<char>& is_kept)
{
  std::vector<SampledDistances> samples = sampleDistances (cloud, planes, labels);
  std::vector<std::optional<double>> thresholds (planes.planes.size());
  Labels above (planes.planes.size(), no_plane);
  bool has_layers = false;
  for (std::size_t p = 0; p < samples.size(); ++p) {
    if (is_kept[p] == 0)
      continue;
    thresholds[p] = thresholdOf (samples[p].distances,
                                 minNoiseOf (samples[p]),
                                 distance_threshold.value_or (0.0));
    if (!thresholds[p])
      continue;
    above[p] = static_cast<std::int32_t> (is_kept.size());
    is_kept.push_back (1);
    has_layers = true;
  }
  for (std::size_t i = 0; has_layers && i < labels.size(); ++i) {
    const std::int32_t plane = labels[i];
    if (plane != no_plane && thresholds[plane] &&
        planes.planes[plane].distance ((*cloud.points)[i]) > *thresholds[plane])
      labels[i] = above[plane];
  }
}

} // namespace pcl_ops::internal
