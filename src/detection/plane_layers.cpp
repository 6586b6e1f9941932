// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/plane_layers.h"

#include "geometry/two_groups.h"

#include <algorithm>
#include <optional>

namespace pcl_ops::internal {

namespace {

// Returns the signed distance [m] that separates two layers, or nothing for one layer.
// \param[in,out] distances signed distances of points; they get sorted
// \param[in] min_apart least distance between two layers [m]
std::optional<double>
thresholdBetweenLayers (std::vector<double>& distances, double min_apart)
{
  constexpr std::size_t min_distances = 50;
  // Share of the variance. Two groups explain .64 of that of a single layer with normal
  // noise, and .75 of that of an evenly thick one (TwoGroups).
  constexpr double min_explained = 0.88;
  if (distances.size() < min_distances)
    return std::nullopt;
  std::sort (distances.begin(), distances.end());
  const TwoGroups layers = bestTwoGroups (distances);
  if (layers.explained_share <= min_explained || layers.apart < min_apart)
    return std::nullopt;
  return 0.5 * (distances[layers.first_above - 1] + distances[layers.first_above]);
}

// Returns the number of points of each plane.
std::vector<std::size_t>
countLabels (const Labels& labels, std::size_t planes)
{
  std::vector<std::size_t> counts (planes, 0);
  for (const std::int32_t label : labels)
    if (label != no_plane)
      ++counts[label];
  return counts;
}

// Returns for each plane the signed distances [m] of 250 to 500 of its points, evenly
// spaced in their order; of all its points if they are fewer than 500.
std::vector<std::vector<double>>
sampleDistances (const Coordinates& points,
                 const std::vector<Plane>& planes,
                 const Labels& labels)
{
  constexpr std::size_t wanted = 500;
  const std::vector<std::size_t> counts = countLabels (labels, planes.size());
  std::vector<std::size_t> seen (planes.size(), 0);
  std::vector<std::vector<double>> distances (planes.size());
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const std::int32_t plane = labels[i];
    if (plane == no_plane)
      continue;
    const std::size_t every = counts[plane] / wanted + 1;
    if (seen[plane] % every == 0)
      distances[plane].push_back (planes[plane].distance (points[i]));
    ++seen[plane];
  }
  return distances;
}

} // namespace

bool
splitLayers (const Coordinates& points,
             const std::vector<Plane>& planes,
             const std::vector<double>& min_apart,
             Labels& labels,
             std::vector<char>& is_kept)
{
  std::vector<std::vector<double>> distances = sampleDistances (points, planes, labels);
  std::vector<std::optional<double>> thresholds (planes.size());
  Labels upper_layer (planes.size(), no_plane);
  bool has_layers = false;
  for (std::size_t p = 0; p < planes.size(); ++p) {
    if (is_kept[p] == 0)
      continue;
    thresholds[p] = thresholdBetweenLayers (distances[p], min_apart[p]);
    if (!thresholds[p])
      continue;
    upper_layer[p] = static_cast<std::int32_t> (is_kept.size());
    is_kept.push_back (1);
    has_layers = true;
  }
  for (std::size_t i = 0; has_layers && i < labels.size(); ++i) {
    const std::int32_t plane = labels[i];
    if (plane != no_plane && thresholds[plane] &&
        planes[plane].distance (points[i]) > *thresholds[plane])
      labels[i] = upper_layer[plane];
  }
  return has_layers;
}

} // namespace pcl_ops::internal
