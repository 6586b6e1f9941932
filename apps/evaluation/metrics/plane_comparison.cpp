// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "plane_comparison.h"

#include <numbers/angles.h>

#include <algorithm>
#include <cmath>

namespace pcl_ops::evaluation {

namespace {

/** \brief Of the centroids. */
Eigen::Vector3d
middleOf (const std::vector<PlaneSegment>& planes)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const PlaneSegment& plane : planes)
    sum += plane.centroid;
  return planes.empty() ? sum : sum / static_cast<double> (planes.size());
}

/** \brief Seen from a zero among them: the error of a rotation is about it. */
std::vector<PlaneSegment>
seenFrom (const Eigen::Vector3d& zero, std::vector<PlaneSegment> planes)
{
  for (PlaneSegment& plane : planes)
    plane.moveBy (-zero);
  return planes;
}

MatchedPlanes
matched (std::size_t first,
         std::size_t second,
         const PlaneSegment& one,
         const PlaneSegment& other)
{
  return {first,
          second,
          apps::toDegrees (angleBetween (one, other)),
          one.plane().distance (other.centroid)};
}

} // namespace

PlaneComparison
comparePlanes (const std::vector<PlaneSegment>& first,
               const std::vector<PlaneSegment>& second,
               const PlaneMatchingParameters& parameters)
{
  const Eigen::Vector3d zero = middleOf (first);
  const PlaneMatches matches = matchPlanes (seenFrom (zero, first),
                                            seenFrom (zero, second),
                                            Eigen::Isometry3d::Identity(),
                                            parameters);
  PlaneComparison comparison;
  std::vector<bool> is_matched (first.size(), false);
  for (std::size_t i = 0; i < second.size(); ++i) {
    if (matches.previous[i] == no_plane) {
      comparison.only_second.push_back (i);
      continue;
    }
    const auto partner = static_cast<std::size_t> (matches.previous[i]);
    is_matched[partner] = true;
    comparison.matched.push_back (matched (partner, i, first[partner], second[i]));
  }
  std::sort (
      comparison.matched.begin(),
      comparison.matched.end(),
      [] (const auto& one, const auto& other) { return one.first < other.first; });
  for (std::size_t i = 0; i < first.size(); ++i)
    if (!is_matched[i])
      comparison.only_first.push_back (i);
  comparison.angle =
      apps::toDegrees (Eigen::AngleAxisd (matches.pose.linear()).angle());
  comparison.shift = matches.pose.translation().norm();
  return comparison;
}

} // namespace pcl_ops::evaluation
