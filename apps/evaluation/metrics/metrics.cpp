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

void
setSegmentationAccuracies (const Confusion& confusion, Metrics& metrics)
{
  std::size_t right = 0;
  for (const Overlap& pair : assignPlanes (confusion))
    right += pair.points;
  const std::size_t on_true_planes = std::accumulate (
      confusion.truth.points.begin(), confusion.truth.points.end(), std::size_t (0));
  const double none_to_find = confusion.result.size() == 0 ? 1.0 : 0.0;
  metrics.segmentation_accuracy = apps::fraction (right, on_true_planes, none_to_find);
  metrics.segmentation_accuracy_all = apps::fraction (
      right + confusion.points_on_no_plane_in_both, confusion.points, 1.0);
}

using Named = std::vector<std::pair<std::string, double>>;

void
appendNamed (const InstanceMetrics& metrics, const std::string& suffix, Named& named)
{
  for (const auto& [name, value] : instance_metrics)
    named.emplace_back (name + suffix, metrics.*value);
}

/** As in "found_75_by_width_below_0.03". */
void
appendNamed (const std::string& by, const SizeClasses& classes, Named& named)
{
  for (const SizeClass& size : classes) {
    const std::string suffix = "_by_" + by + '_' + size.name ('_');
    named.emplace_back ("planes" + suffix, double (size.planes));
    named.emplace_back ("found" + suffix, double (size.found_50));
    named.emplace_back ("found_75" + suffix, double (size.found_75));
  }
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
  metrics.classification_accuracy = classificationAccuracy (points, parameters);
  setSegmentationAccuracies (confusion, metrics);
  metrics.points_off_planes_called_planes = apps::fraction (
      confusion.points_off_planes - confusion.points_on_no_plane_in_both,
      confusion.points_off_planes,
      0.0);
  metrics.by_size = sizeClasses (confusion);
  metrics.by_width = widthClasses (confusion, widthsOf (points.cloud, confusion.truth));
  metrics.at_50 = instanceMetrics (confusion, 0.50);
  metrics.at_75 = instanceMetrics (confusion, 0.75);
  return metrics;
}

std::vector<std::pair<std::string, double>>
namedMetrics (const Metrics& metrics)
{
  Named named{{"classification_accuracy", metrics.classification_accuracy},
              {"segmentation_accuracy", metrics.segmentation_accuracy},
              {"segmentation_accuracy_all", metrics.segmentation_accuracy_all}};
  appendNamed (metrics.at_50, "", named);
  appendNamed (metrics.at_75, "_75", named);
  return named;
}

std::vector<std::pair<std::string, double>>
namedCounts (const Metrics& metrics)
{
  Named named;
  appendNamed ("points", metrics.by_size, named);
  appendNamed ("width", metrics.by_width, named);
  return named;
}

} // namespace pcl_ops::evaluation
