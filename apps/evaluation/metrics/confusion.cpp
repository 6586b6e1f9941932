// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "confusion.h"

#include "hungarian.h"

#include <algorithm>
#include <stdexcept>
#include <unordered_map>

namespace pcl_ops::evaluation {

namespace {

/** 0.8 GB of matrix; no cloud has that many planes, only a wrong label field does. */
constexpr std::size_t max_plane_pairs = 100'000'000;

} // namespace

Confusion
confusionOf (const PlaneLabels& truth, const PlaneLabels& result)
{
  Confusion confusion{planeIds (truth), planeIds (result), {}, truth.size(), 0, 0};
  const std::uint64_t columns = confusion.result.size();
  std::unordered_map<std::uint64_t, std::size_t> points_of_pair;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    confusion.points_off_planes += truth[i] == 0;
    if (truth[i] == 0 && result[i] == 0)
      ++confusion.points_on_no_plane_in_both;
    else if (truth[i] != 0 && result[i] != 0)
      ++points_of_pair[confusion.truth.of_point[i] * columns +
                       confusion.result.of_point[i]];
  }
  for (const auto& [pair, points] : points_of_pair)
    confusion.overlaps.push_back ({static_cast<std::uint32_t> (pair / columns),
                                   static_cast<std::uint32_t> (pair % columns),
                                   points});
  std::sort (confusion.overlaps.begin(),
             confusion.overlaps.end(),
             [] (const Overlap& a, const Overlap& b) {
               return a.truth != b.truth ? a.truth < b.truth : a.result < b.result;
             });
  return confusion;
}

std::vector<Overlap>
assignPlanes (const Confusion& confusion)
{
  if (confusion.truth.size() * confusion.result.size() > max_plane_pairs)
    throw std::length_error (std::to_string (confusion.truth.size()) + " and " +
                             std::to_string (confusion.result.size()) +
                             " labels are too many for planes");
  Eigen::MatrixXd common =
      Eigen::MatrixXd::Zero (confusion.truth.size(), confusion.result.size());
  for (const Overlap& overlap : confusion.overlaps)
    common (overlap.truth, overlap.result) = static_cast<double> (overlap.points);
  const std::vector<std::ptrdiff_t> result_of = maximumAssignment (common);

  std::vector<Overlap> pairs;
  for (const Overlap& overlap : confusion.overlaps)
    if (result_of[overlap.truth] == static_cast<std::ptrdiff_t> (overlap.result))
      pairs.push_back (overlap);
  return pairs;
}

} // namespace pcl_ops::evaluation
