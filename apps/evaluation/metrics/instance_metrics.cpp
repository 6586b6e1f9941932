// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "instance_metrics.h"

#include <numbers/fraction.h>

#include <algorithm>

namespace pcl_ops::evaluation {

namespace {

/** What has been said about each plane of one side. */
struct Verdicts {
  std::vector<bool> matched;
  /** Broken up (a true plane) or swallowing several (a found one). */
  std::vector<bool> split;
  /** A part of the other side's split plane. */
  std::vector<bool> part;

  explicit Verdicts (std::size_t planes)
  : matched (planes, false), split (planes, false), part (planes, false)
  {}

  std::size_t
  unexplained () const
  {
    std::size_t count = 0;
    for (std::size_t i = 0; i < matched.size(); ++i)
      count += !matched[i] && !split[i] && !part[i];
    return count;
  }
};

/** Sum of the IoU of the pairs; marks both planes of each. */
double
matchPlanes (const Confusion& confusion,
             double threshold,
             Verdicts& truth,
             Verdicts& result)
{
  std::vector<Overlap> candidates;
  for (const Overlap& overlap : confusion.overlaps)
    if (confusion.iou (overlap) >= threshold)
      candidates.push_back (overlap);
  std::stable_sort (
      candidates.begin(), candidates.end(), [&] (const Overlap& a, const Overlap& b) {
        return confusion.iou (a) > confusion.iou (b);
      });
  double sum = 0.0;
  for (const Overlap& pair : candidates) {
    if (truth.matched[pair.truth] || result.matched[pair.result])
      continue;
    truth.matched[pair.truth] = result.matched[pair.result] = true;
    sum += confusion.iou (pair);
  }
  return sum;
}

bool
reaches (double threshold, std::size_t part, std::size_t whole)
{
  return static_cast<double> (part) >= threshold * static_cast<double> (whole);
}

/** Marks every plane of side \p whole on which two or more planes of the other side
 * lie, and which they together cover, both by the threshold. */
void
markSplits (const Confusion& confusion,
            double threshold,
            Side whole,
            Verdicts& verdicts,
            Verdicts& other_verdicts)
{
  const Side part = whole == Side::Truth ? Side::Result : Side::Truth;
  const std::vector<std::size_t>& points_of_whole = confusion.planes (whole).points;
  std::vector<std::size_t> parts (points_of_whole.size(), 0);
  std::vector<std::size_t> covered (points_of_whole.size(), 0);
  std::vector<Overlap> on_whole;
  for (const Overlap& overlap : confusion.overlaps)
    if (reaches (threshold,
                 overlap.points,
                 confusion.planes (part).points[overlap.plane (part)])) {
      on_whole.push_back (overlap);
      ++parts[overlap.plane (whole)];
      covered[overlap.plane (whole)] += overlap.points;
    }
  for (std::size_t i = 0; i < parts.size(); ++i)
    verdicts.split[i] =
        parts[i] > 1 && reaches (threshold, covered[i], points_of_whole[i]);
  for (const Overlap& overlap : on_whole)
    if (verdicts.split[overlap.plane (whole)])
      other_verdicts.part[overlap.plane (part)] = true;
}

std::size_t
countTrue (const std::vector<bool>& values)
{
  return static_cast<std::size_t> (std::count (values.begin(), values.end(), true));
}

} // namespace

NamedValues
instanceMetrics (const Confusion& confusion,
                 double threshold,
                 const std::string& suffix)
{
  const std::size_t truth_planes = confusion.truth.size();
  const std::size_t result_planes = confusion.result.size();
  Verdicts truth (truth_planes), result (result_planes);
  const double iou_sum = matchPlanes (confusion, threshold, truth, result);
  markSplits (confusion, threshold, Side::Truth, truth, result);
  markSplits (confusion, threshold, Side::Result, result, truth);

  const std::size_t matches = countTrue (truth.matched);
  const double both_empty = truth_planes + result_planes == 0 ? 1.0 : 0.0;
  const double f_score =
      apps::fraction (2 * matches, truth_planes + result_planes, both_empty);
  const double mean_iou =
      matches == 0 ? both_empty : iou_sum / static_cast<double> (matches);
  const auto ofTruth = [&] (std::size_t planes, double otherwise = 0.0) {
    return apps::fraction (planes, truth_planes, otherwise);
  };
  const auto ofResult = [&] (std::size_t planes, double otherwise = 0.0) {
    return apps::fraction (planes, result_planes, otherwise);
  };
  return {{"precision" + suffix, ofResult (matches, both_empty)},
          {"recall" + suffix, ofTruth (matches, both_empty)},
          {"f_score" + suffix, f_score},
          {"mean_iou" + suffix, mean_iou},
          {"panoptic_quality" + suffix, mean_iou * f_score},
          {"over_segmentation" + suffix, ofTruth (countTrue (truth.split))},
          {"under_segmentation" + suffix, ofResult (countTrue (result.split))},
          {"noise" + suffix, ofResult (result.unexplained())},
          {"missed" + suffix, ofTruth (truth.unexplained())}};
}

std::vector<bool>
foundTruePlanes (const Confusion& confusion, double threshold)
{
  Verdicts truth (confusion.truth.size()), result (confusion.result.size());
  matchPlanes (confusion, threshold, truth, result);
  return truth.matched;
}

} // namespace pcl_ops::evaluation
