// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "leaves/leaf_labels.h"

#include "base/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_ops::internal {

namespace {

/** \brief A plane that points of a leaf may be on. */
struct CandidatePlane {
  std::int32_t number;
  Plane plane;
  double inverse_variance; // [1/m^2]
  double cost;             // 2 ln sigma
  double max_distance;     // [m]
};

/** \brief What the labeling of one leaf needs. */
struct LeafLabeling {
  const LeafCloud& cloud;
  const LeafPlanes& planes;
  double noise_factor;
  double max_distance;

  std::vector<CandidatePlane>
  candidatesAround (std::size_t leaf) const
  {
    std::vector<CandidatePlane> candidates;
    for (const std::uint32_t k : cloud.neighbors[leaf]) {
      const std::int32_t number = planes.plane_of_leaf[k];
      const bool is_known =
          number == no_plane || std::any_of (candidates.begin(),
                                             candidates.end(),
                                             [&] (const auto& candidate) {
                                               return candidate.number == number;
                                             });
      if (is_known)
        continue;
      const double noise = std::max (planes.noise[k], cloud.min_noise[leaf]);
      candidates.push_back ({number,
                             planes.planes[number],
                             1.0 / (noise * noise),
                             2.0 * std::log (noise),
                             std::min (max_distance, noise_factor * noise)});
    }
    return candidates;
  }

  // Whether nearly all of the leaf's points are on its plane, and no other is near.
  bool
  isWholly (std::size_t leaf, const std::vector<CandidatePlane>& candidates) const
  {
    constexpr double max_squared = 4.0; // 2 sigma
    const CandidatePlane& only = candidates.front();
    return candidates.size() == 1 && planes.plane_of_leaf[leaf] == only.number &&
           !(max_distance < std::numeric_limits<double>::infinity()) &&
           meanSquaredDistance (cloud.moments[leaf], only.plane) *
                   only.inverse_variance <
               max_squared;
  }

  void
  label (std::size_t leaf, Labels& labels) const
  {
    const std::vector<CandidatePlane> candidates = candidatesAround (leaf);
    if (candidates.empty())
      return;
    const Leaf& own = cloud.leaves[leaf];
    const bool is_wholly = isWholly (leaf, candidates);
    for (std::uint32_t p = own.begin; p < own.end; ++p)
      labels[p] = is_wholly ? candidates.front().number
                            : likeliest (candidates, (*cloud.points)[p]);
  }

  static std::int32_t
  likeliest (const std::vector<CandidatePlane>& candidates,
             const Eigen::Vector3d& point)
  {
    std::int32_t best = no_plane;
    double least = std::numeric_limits<double>::infinity();
    for (const CandidatePlane& candidate : candidates) {
      const double distance = std::abs (candidate.plane.distance (point));
      const double cost =
          distance * distance * candidate.inverse_variance + candidate.cost;
      if (distance < candidate.max_distance && cost < least) {
        least = cost;
        best = candidate.number;
      }
    }
    return best;
  }
};

} // namespace

Labels
labelPoints (const LeafCloud& cloud,
             const LeafPlanes& planes,
             double noise_factor,
             std::optional<double> distance_threshold,
             unsigned threads)
{
  Labels labels (cloud.points->size(), no_plane);
  const LeafLabeling labeling{
      cloud,
      planes,
      noise_factor,
      distance_threshold.value_or (std::numeric_limits<double>::infinity())};
  forEach (
      threads, cloud.size(), [&] (std::size_t leaf) { labeling.label (leaf, labels); });
  return labels;
}

std::vector<std::size_t>
countLabels (const Labels& labels, std::size_t planes)
{
  std::vector<std::size_t> counts (planes, 0);
  for (const std::int32_t label : labels)
    if (label != no_plane)
      ++counts[label];
  return counts;
}

Labels
planesOfLeaves (const std::vector<Leaf>& leaves, const Labels& labels)
{
  Labels planes;
  planes.reserve (leaves.size());
  for (const Leaf& leaf : leaves)
    planes.push_back (labels[leaf.begin + (leaf.end - leaf.begin) / 2]);
  return planes;
}

} // namespace pcl_ops::internal
