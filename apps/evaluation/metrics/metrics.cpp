// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "metrics.h"

#include <pcl/common/point_tests.h>

#include <numbers/fraction.h>

#include <numeric>
#include <stdexcept>

namespace pcl_ops::evaluation {

namespace {

struct FinitePoints {
  XyzCloud cloud;
  PlaneLabels truth;
  PlaneLabels result;
};

FinitePoints
finiteOf (const XyzCloud& cloud, const PlaneLabels& truth, const PlaneLabels& result)
{
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

double
classificationAccuracy (const FinitePoints& points, const ClassParameters& parameters)
{
  const auto truth = pointClasses (points.cloud, points.truth, parameters);
  const auto result = pointClasses (points.cloud, points.result, parameters);
  std::size_t right = 0;
  for (std::size_t i = 0; i < truth.size(); ++i)
    right += truth[i] == result[i];
  return apps::fraction (right, truth.size(), 1.0);
}

/** The paper's, over true planes, and the same over all points. */
std::pair<double, double>
segmentationAccuracies (const Confusion& confusion)
{
  std::size_t right = 0;
  for (const Overlap& pair : assignPlanes (confusion))
    right += pair.points;
  const std::size_t on_true_planes = std::accumulate (
      confusion.truth.points.begin(), confusion.truth.points.end(), std::size_t (0));
  const double none_to_find = confusion.result.size() == 0 ? 1.0 : 0.0;
  return {apps::fraction (right, on_true_planes, none_to_find),
          apps::fraction (
              right + confusion.points_on_no_plane_in_both, confusion.points, 1.0)};
}

} // namespace

Metrics
compareLabels (const XyzCloud& cloud,
               const PlaneLabels& truth,
               const PlaneLabels& result,
               const ClassParameters& parameters)
{
  if (truth.size() != cloud.size() || result.size() != cloud.size())
    throw std::invalid_argument (std::to_string (cloud.size()) + " points, " +
                                 std::to_string (truth.size()) + " true labels and " +
                                 std::to_string (result.size()) +
                                 " found ones do not belong together");
  const FinitePoints points = finiteOf (cloud, truth, result);
  const Confusion confusion = confusionOf (points.truth, points.result);

  Metrics metrics;
  metrics.points = points.cloud.size();
  metrics.truth_planes = confusion.truth.size();
  metrics.result_planes = confusion.result.size();
  const auto [accuracy, accuracy_all] = segmentationAccuracies (confusion);
  metrics.named = {
      {"classification_accuracy", classificationAccuracy (points, parameters)},
      {"segmentation_accuracy", accuracy},
      {"segmentation_accuracy_all", accuracy_all}};
  for (const auto& [threshold, suffix] : {std::pair (0.50, ""), {0.75, "_75"}}) {
    const NamedValues values = instanceMetrics (confusion, threshold, suffix);
    metrics.named.insert (metrics.named.end(), values.begin(), values.end());
  }
  metrics.points_off_planes_called_planes = apps::fraction (
      confusion.points_off_planes - confusion.points_on_no_plane_in_both,
      confusion.points_off_planes,
      0.0);
  metrics.by_size = sizeClasses (confusion);
  metrics.by_width = widthClasses (confusion, widthsOf (points.cloud, confusion.truth));
  return metrics;
}

NamedValues
namedCounts (const Metrics& metrics)
{
  NamedValues named;
  for (const auto& [by, classes] :
       {std::pair ("points", &metrics.by_size), {"width", &metrics.by_width}})
    for (const SizeClass& size : *classes) {
      const std::string suffix = std::string ("_by_") + by + '_' + size.name ('_');
      named.emplace_back ("planes" + suffix, double (size.planes));
      named.emplace_back ("found" + suffix, double (size.found_50));
      named.emplace_back ("found_75" + suffix, double (size.found_75));
    }
  return named;
}

} // namespace pcl_ops::evaluation
