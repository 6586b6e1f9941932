// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "partitions.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace pcl_ops::evaluation {

namespace {

/** How many of the points on true planes each true plane has in common with each part
 * of the result. The parts are the found planes and, last, the points on no found
 * plane. */
struct CommonPoints {
  /** Number of points of each true plane, and of each part of the result. */
  std::vector<double> of_truth, of_result;
  /** True planes and parts of the result with common points. */
  std::vector<Overlap> pairs;
  double all = 0.0; // number of points on true planes
};

CommonPoints
commonPoints (const Confusion& confusion)
{
  const auto no_found_plane = std::uint32_t (confusion.result.size()); // the last part
  CommonPoints common;
  common.pairs = confusion.overlaps;
  common.of_truth.assign (confusion.truth.points.begin(), confusion.truth.points.end());
  // For each true plane the number of points on no found plane.
  std::vector<std::size_t> on_none = confusion.truth.points;
  for (const Overlap& pair : confusion.overlaps)
    on_none[pair.truth] -= pair.points;
  for (std::uint32_t plane = 0; plane < on_none.size(); ++plane)
    if (on_none[plane] > 0)
      common.pairs.push_back ({plane, no_found_plane, on_none[plane]});
  common.of_result.assign (no_found_plane + 1, 0.0);
  for (const Overlap& pair : common.pairs) {
    common.of_result[pair.result] += double (pair.points);
    common.all += double (pair.points);
  }
  return common;
}

/** H (T | R) + H (R | T) = 2 H (T, R) - H (T) - H (R) [bits], with the entropy H of the
 * true planes T and of the parts R of the result. */
double
variationOfInformation (const CommonPoints& common)
{
  double bits = 0.0;
  for (const Overlap& pair : common.pairs) {
    const double points = double (pair.points);
    bits -= points * (std::log2 (points / common.of_truth[pair.truth]) +
                      std::log2 (points / common.of_result[pair.result]));
  }
  return std::max (0.0, bits / common.all);
}

/** Number of ordered pairs of different points. */
double
pairsOf (double points)
{
  return points * (points - 1.0);
}

/** The share of the pairs of points that truth and result both join or both separate.
 */
double
randIndex (const CommonPoints& common)
{
  // Ordered pairs of points, counted by where they are together.
  double together_in_both = 0.0; // on one true plane and in one part of the result
  double together_in_sum = 0.0;  // on one true plane, plus those in one part
  for (const Overlap& pair : common.pairs)
    together_in_both += pairsOf (double (pair.points));
  for (const std::vector<double>* parts : {&common.of_truth, &common.of_result})
    for (const double points : *parts)
      together_in_sum += pairsOf (points);
  const double all_pairs = pairsOf (common.all);
  return all_pairs > 0.0
             ? (all_pairs - together_in_sum + 2.0 * together_in_both) / all_pairs
             : 1.0;
}

/** The mean over points and over truth and result of the largest intersection over
 * union (IoU) of the point's part with a part of the other labeling. */
double
segmentationCovering (const CommonPoints& common)
{
  std::vector<double> best_iou_of_truth (common.of_truth.size(), 0.0);
  std::vector<double> best_iou_of_result (common.of_result.size(), 0.0);
  for (const Overlap& pair : common.pairs) {
    const double common_points = double (pair.points);
    const double iou = common_points / (common.of_truth[pair.truth] +
                                        common.of_result[pair.result] - common_points);
    best_iou_of_truth[pair.truth] = std::max (best_iou_of_truth[pair.truth], iou);
    best_iou_of_result[pair.result] = std::max (best_iou_of_result[pair.result], iou);
  }
  double covered = 0.0;
  for (std::size_t plane = 0; plane < best_iou_of_truth.size(); ++plane)
    covered += common.of_truth[plane] * best_iou_of_truth[plane];
  for (std::size_t part = 0; part < best_iou_of_result.size(); ++part)
    covered += common.of_result[part] * best_iou_of_result[part];
  return covered / (2.0 * common.all);
}

} // namespace

NamedValues
partitionMetrics (const Confusion& confusion)
{
  const CommonPoints common = commonPoints (confusion);
  const bool has_planes = common.all > 0.0;
  return {
      {"variation_of_information", has_planes ? variationOfInformation (common) : 0.0},
      {"rand_index", has_planes ? randIndex (common) : 1.0},
      {"segmentation_covering", has_planes ? segmentationCovering (common) : 1.0}};
}

double
agreementOf (const PlaneLabels& first, const PlaneLabels& second)
{
  if (first.size() != second.size())
    throw std::invalid_argument ("agreementOf: labelings of different points");
  Confusion confusion = confusionOf (first, second);
  std::size_t on_planes = 0; // points on a plane in either labeling
  for (const PlaneIds* planes : {&confusion.truth, &confusion.result})
    for (const std::size_t points : planes->points)
      on_planes += points;
  for (const Overlap& pair : confusion.overlaps)
    on_planes -= pair.points;
  std::stable_sort (
      confusion.overlaps.begin(),
      confusion.overlaps.end(),
      [] (const Overlap& a, const Overlap& b) { return a.points > b.points; });
  std::vector<char> is_matched_in_first (confusion.truth.size());
  std::vector<char> is_matched_in_second (confusion.result.size());
  std::size_t on_matched_planes = 0; // points on both planes of a match
  for (const Overlap& pair : confusion.overlaps) {
    if (is_matched_in_first[pair.truth] || is_matched_in_second[pair.result])
      continue;
    is_matched_in_first[pair.truth] = is_matched_in_second[pair.result] = 1;
    on_matched_planes += pair.points;
  }
  return on_planes > 0 ? double (on_matched_planes) / double (on_planes) : 1.0;
}

} // namespace pcl_ops::evaluation
