// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "metrics.h"

#include <pcl/common/point_tests.h>

#include "confusion.h"
#include <numbers/statistics.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace pcl_ops::evaluation {

namespace {

struct FinitePoints {
  XyzCloud cloud;
  PlaneLabels truth, result;
};

FinitePoints
finiteOf (const XyzCloud& cloud, const PlaneLabels& truth, const PlaneLabels& result)
{
  if (truth.size() != cloud.size() || result.size() != cloud.size())
    throw std::invalid_argument (std::to_string (cloud.size()) + " points, " +
                                 std::to_string (truth.size()) + " true labels and " +
                                 std::to_string (result.size()) +
                                 " found ones do not belong together");
  FinitePoints finite;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (!pcl::isXYZFinite (cloud[i]))
      continue;
    finite.cloud.push_back (cloud[i]);
    finite.truth.push_back (truth[i]);
    finite.result.push_back (result[i]);
  }
  return finite;
}

/** Points whose true and found plane have the same class: Other for no plane, and where
 * the points of a label span none. */
double
classificationAccuracy (const Confusion& confusion,
                        const std::vector<PlaneSegment>& truth,
                        const std::vector<PlaneSegment>& result)
{
  const auto classOf = [] (const std::vector<PlaneSegment>& planes, std::uint32_t id) {
    return id == PlaneIds::none ? Orientation::Other : planes[id].orientation;
  };
  std::size_t right = 0;
  for (std::size_t i = 0; i < confusion.points; ++i)
    right += classOf (truth, confusion.truth.of_point[i]) ==
             classOf (result, confusion.result.of_point[i]);
  return apps::fraction (right, confusion.points, 1.0);
}

/** What has been said about each plane of one side. */
struct Verdicts {
  const PlaneIds& planes;
  /** Of the plane of this side. */
  std::uint32_t Overlap::*id;
  std::vector<bool> matched = std::vector<bool> (planes.size(), false);
  /** Broken up (a true plane) or swallowing several (a found one). */
  std::vector<bool> split = matched;
  /** A part of the other side's split plane. */
  std::vector<bool> part = matched;

  std::size_t
  unexplained () const
  {
    std::size_t count = 0;
    for (std::size_t i = 0; i < matched.size(); ++i)
      count += !matched[i] && !split[i] && !part[i];
    return count;
  }
};

/** Marks every plane of the side \p wholes on which two or more planes of the other
 * side lie, and which they together cover, both by the threshold. */
void
markSplits (const Confusion& confusion,
            double threshold,
            Verdicts& wholes,
            Verdicts& others)
{
  const auto reaches = [threshold] (std::size_t points, std::size_t all) {
    return static_cast<double> (points) >= threshold * static_cast<double> (all);
  };
  std::vector<std::size_t> parts (wholes.planes.size(), 0), covered = parts;
  std::vector<Overlap> on_whole;
  for (const Overlap& overlap : confusion.overlaps)
    if (reaches (overlap.points, others.planes.points[overlap.*others.id])) {
      on_whole.push_back (overlap);
      ++parts[overlap.*wholes.id];
      covered[overlap.*wholes.id] += overlap.points;
    }
  for (std::size_t i = 0; i < parts.size(); ++i)
    wholes.split[i] = parts[i] > 1 && reaches (covered[i], wholes.planes.points[i]);
  for (const Overlap& overlap : on_whole)
    if (wholes.split[overlap.*wholes.id])
      others.part[overlap.*others.id] = true;
}

/** What is said about the planes of both sides. */
struct Matching {
  Verdicts truth, result;
  /** Of the pairs of planes that are one. */
  double iou_sum = 0.0;
};

/** Matches pairs with an IoU from a threshold on, the largest first. At more than one
 * half no plane has two candidates. */
Matching
matchPlanes (const Confusion& confusion, double threshold)
{
  std::vector<Overlap> candidates;
  for (const Overlap& overlap : confusion.overlaps)
    if (confusion.iou (overlap) >= threshold)
      candidates.push_back (overlap);
  std::stable_sort (
      candidates.begin(), candidates.end(), [&] (const Overlap& a, const Overlap& b) {
        return confusion.iou (a) > confusion.iou (b);
      });
  Matching matching{{confusion.truth, &Overlap::truth},
                    {confusion.result, &Overlap::result}};
  auto& [truth, result, iou_sum] = matching;
  for (const Overlap& pair : candidates) {
    if (truth.matched[pair.truth] || result.matched[pair.result])
      continue;
    truth.matched[pair.truth] = result.matched[pair.result] = true;
    iou_sum += confusion.iou (pair);
  }
  markSplits (confusion, threshold, truth, result);
  markSplits (confusion, threshold, result, truth);
  return matching;
}

/** Planes as instances. */
void
addInstanceMetrics (const Matching& matching,
                    const std::string& suffix,
                    NamedValues& named)
{
  const auto& [truth, result, iou_sum] = matching;
  const std::size_t truth_planes = truth.planes.size();
  const std::size_t result_planes = result.planes.size();
  const auto count = [] (const std::vector<bool>& marks) {
    return std::size_t (std::count (marks.begin(), marks.end(), true));
  };
  const std::size_t matches = count (truth.matched), all = truth_planes + result_planes;
  const double both_empty = all == 0 ? 1.0 : 0.0;
  const double f_score = apps::fraction (2 * matches, all, both_empty);
  const double mean_iou = matches == 0 ? both_empty : iou_sum / double (matches);
  for (const auto& [name, value] : NamedValues{
           {"precision", apps::fraction (matches, result_planes, both_empty)},
           {"recall", apps::fraction (matches, truth_planes, both_empty)},
           {"f_score", f_score},
           {"mean_iou", mean_iou},
           {"panoptic_quality", mean_iou * f_score},
           {"over_segmentation", apps::fraction (count (truth.split), truth_planes, 0)},
           {"under_segmentation",
            apps::fraction (count (result.split), result_planes, 0)},
           {"noise", apps::fraction (result.unexplained(), result_planes, 0)},
           {"missed", apps::fraction (truth.unexplained(), truth_planes, 0)}})
    named.emplace_back (name + suffix, value);
}

/** \param[in] sizes of the true planes
 * \param[in] limits between classes, ascending */
SizeClasses
classesOf (const Matching& at_50,
           const Matching& at_75,
           const std::vector<double>& sizes,
           const std::vector<double>& limits)
{
  SizeClasses classes (1);
  for (const double limit : limits) {
    classes.back().below = limit;
    classes.push_back ({limit});
  }
  for (std::size_t plane = 0; plane < sizes.size(); ++plane) {
    auto of_plane = classes.begin();
    while (of_plane->below && sizes[plane] >= *of_plane->below)
      ++of_plane;
    ++of_plane->planes;
    of_plane->found_50 += at_50.truth.matched[plane];
    of_plane->found_75 += at_75.truth.matched[plane];
  }
  return classes;
}

std::vector<double>
widthsOf (const std::vector<PlaneSegment>& planes)
{
  constexpr double squared_side_over_variance = 12.0; // of an even spread
  std::vector<double> widths;
  for (const PlaneSegment& plane : planes) {
    const std::optional<PlaneFit> fit = fitPlane (plane.moments);
    widths.push_back (fit ? std::sqrt (squared_side_over_variance * fit->variances[1])
                          : 0.0);
  }
  return widths;
}

} // namespace

Metrics
compareLabels (const XyzCloud& cloud,
               const PlaneLabels& truth,
               const PlaneLabels& result,
               const ClassParameters& parameters)
{
  const FinitePoints points = finiteOf (cloud, truth, result);
  const Confusion confusion = confusionOf (points.truth, points.result);
  const std::vector<std::size_t>& sizes = confusion.truth.points;
  const std::size_t right = pointsOfAssignment (confusion),
                    off_in_both = confusion.points_on_no_plane_in_both,
                    off_planes = confusion.points_off_planes;
  const Matching at_50 = matchPlanes (confusion, 0.50),
                 at_75 = matchPlanes (confusion, 0.75);
  const auto truth_planes = planesOf (points.cloud, confusion.truth, parameters),
             result_planes = planesOf (points.cloud, confusion.result, parameters);

  Metrics metrics;
  metrics.points = confusion.points;
  metrics.truth_planes = confusion.truth.size();
  metrics.result_planes = confusion.result.size();
  metrics.named = {{"classification_accuracy",
                    classificationAccuracy (confusion, truth_planes, result_planes)},
                   {"segmentation_accuracy",
                    apps::fraction (right,
                                    confusion.points - off_planes,
                                    metrics.result_planes == 0 ? 1.0 : 0.0)},
                   {"segmentation_accuracy_all",
                    apps::fraction (right + off_in_both, confusion.points, 1.0)}};
  addInstanceMetrics (at_50, "", metrics.named);
  addInstanceMetrics (at_75, "_75", metrics.named);
  metrics.points_off_planes_called_planes =
      apps::fraction (off_planes - off_in_both, off_planes, 0.0);
  metrics.by_size = classesOf (
      at_50, at_75, {sizes.begin(), sizes.end()}, {200, 500, 1000, 3000, 10'000});
  metrics.by_width =
      classesOf (at_50, at_75, widthsOf (truth_planes), {0.03, 0.06, 0.12, 0.25, 1.0});
  return metrics;
}

NamedValues
namedCounts (const Metrics& metrics)
{
  NamedValues named;
  for (const auto& [by, classes] :
       {std::pair ("points", &metrics.by_size), {"width", &metrics.by_width}})
    for (const SizeClass& size : *classes) {
      std::ostringstream suffix;
      suffix << "_by_" << by << (size.below ? "_below_" : "_from_")
             << size.below.value_or (size.from);
      named.emplace_back ("planes" + suffix.str(), double (size.planes));
      named.emplace_back ("found" + suffix.str(), double (size.found_50));
      named.emplace_back ("found_75" + suffix.str(), double (size.found_75));
    }
  return named;
}

} // namespace pcl_ops::evaluation
