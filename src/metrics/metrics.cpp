// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "metrics.h"

#include <pcl/common/point_tests.h>

#include "assignment.h"
#include "partitions.h"
#include "plane_marks.h"

#include <array>
#include <cmath>
#include <map>
#include <sstream>
#include <stdexcept>

namespace pcl_ops::evaluation {

namespace {

/** Returns part / whole, or \p share_of_none where the whole is 0. */
double
shareOf (std::size_t part, std::size_t whole, double share_of_none)
{
  return whole == 0 ? share_of_none : double (part) / double (whole);
}

/** Returns the largest number of points that true planes have in common with found
 * planes under a one-to-one assignment (the paper's Hungarian assignment, section IV).
 * \throw std::length_error for more than 10^8 pairs of planes */
std::size_t
pointsOfAssignment (const Confusion& confusion)
{
  // More pairs would be a matrix of over 0.8 GB. No real cloud has so many planes, only
  // a field of other numbers that was mistaken for labels.
  constexpr std::size_t max_plane_pairs = 100'000'000;
  const std::size_t rows = confusion.truth.size();
  const std::size_t columns = confusion.result.size();
  if (rows * columns > max_plane_pairs)
    throw std::length_error (std::to_string (rows) + " and " +
                             std::to_string (columns) +
                             " labels are too many for planes");
  Eigen::MatrixXd common_points = Eigen::MatrixXd::Zero (rows, columns);
  for (const Overlap& overlap : confusion.overlaps)
    common_points (overlap.truth, overlap.result) = double (overlap.points);
  // maximumAssignment takes no more rows than columns.
  return std::size_t (maximumAssignment (
      rows > columns ? Eigen::MatrixXd (common_points.transpose()) : common_points));
}

/** Returns the share of points whose class is the same in truth and result. The class
 * is the orientation of the point's plane; Other for points on no plane, or whose label
 * spans no plane. */
double
classificationAccuracy (const Confusion& confusion,
                        const std::vector<PlaneSegment>& truth,
                        const std::vector<PlaneSegment>& result)
{
  const auto classOf = [] (const std::vector<PlaneSegment>& planes, std::uint32_t id) {
    return id == PlaneIds::none ? Orientation::Other : planes[id].orientation;
  };
  const std::size_t points = confusion.truth.of_point.size();
  std::size_t right = 0;
  for (std::size_t i = 0; i < points; ++i)
    if (classOf (truth, confusion.truth.of_point[i]) ==
        classOf (result, confusion.result.of_point[i]))
      ++right;
  return shareOf (right, points, 1.0);
}

/** Returns the metrics of instance segmentation, with planes as instances. */
NamedValues
instanceMetrics (const Matching& matching)
{
  const Marks& truth = matching.truth;
  const Marks& result = matching.result;
  const std::size_t truth_planes = truth.planes.size();
  const std::size_t result_planes = result.planes.size();
  const std::size_t matches = countMarked (truth.is_matched);
  const std::size_t planes_of_both = truth_planes + result_planes;
  // If neither side has a plane, the result is perfect.
  const double without_matches = planes_of_both == 0 ? 1.0 : 0.0;
  const double f_score = shareOf (2 * matches, planes_of_both, without_matches);
  const double mean_iou =
      matches == 0 ? without_matches : matching.iou_sum / double (matches);
  return {
      {"precision", shareOf (matches, result_planes, without_matches)},
      {"recall", shareOf (matches, truth_planes, without_matches)},
      {"f_score", f_score},
      {"mean_iou", mean_iou},
      {"panoptic_quality", mean_iou * f_score},
      {"over_segmentation", shareOf (countMarked (truth.is_split), truth_planes, 0)},
      {"under_segmentation", shareOf (countMarked (result.is_split), result_planes, 0)},
      {"noise", shareOf (result.countUnmarked(), result_planes, 0)},
      {"missed", shareOf (truth.countUnmarked(), truth_planes, 0)}};
}

// An array has no destructor to run: Python threads may still compare at program exit.
using ClassLimits = std::array<double, 5>;
// The limits are chosen by hand; their values are part of published names
// (namedCounts).
constexpr ClassLimits limits_of_points{200, 500, 1000, 3000, 10'000}; // [points]
constexpr ClassLimits limits_of_width{0.03, 0.06, 0.12, 0.25, 1.0};   // [m]

/** Returns classes without planes: below the first limit, from each limit to below the
 * next one, and from the last limit on. */
SizeClasses
emptyClasses (const ClassLimits& limits)
{
  SizeClasses classes (1);
  for (const double limit : limits) {
    classes.back().below = limit;
    classes.push_back ({limit});
  }
  return classes;
}

/** Counts true planes, and how many of them are matched, by size.
 * \param[in] sizes of the true planes, in the unit of \p limits */
SizeClasses
classesOf (const Matching& at_50,
           const Matching& at_75,
           const std::vector<double>& sizes,
           const ClassLimits& limits)
{
  SizeClasses classes = emptyClasses (limits);
  for (std::size_t plane = 0; plane < sizes.size(); ++plane) {
    auto of_plane = classes.begin();
    while (of_plane->below && sizes[plane] >= *of_plane->below)
      ++of_plane;
    ++of_plane->planes;
    if (at_50.truth.is_matched[plane])
      ++of_plane->found_50;
    if (at_75.truth.is_matched[plane])
      ++of_plane->found_75;
  }
  return classes;
}

/** Returns the points whose truth is known. */
pcl::Indices
knownOf (const pcl::Indices& points, const std::vector<char>& is_ignored)
{
  pcl::Indices known;
  for (const pcl::index_t i : points)
    if (is_ignored.empty() || is_ignored[std::size_t (i)] == 0)
      known.push_back (i);
  return known;
}

/** Returns the result without those planes that have more points of unknown truth than
 * points of known truth. */
PlaneLabels
withoutUnknownPlanes (PlaneLabels result, const std::vector<char>& is_ignored)
{
  if (is_ignored.empty())
    return result;
  std::map<std::uint32_t, std::size_t> points;  // number of points by label
  std::map<std::uint32_t, std::size_t> ignored; // number of those with unknown truth
  for (std::size_t i = 0; i < result.size(); ++i) {
    ++points[result[i]];
    if (is_ignored[i] != 0)
      ++ignored[result[i]];
  }
  for (std::uint32_t& label : result)
    if (2 * ignored[label] > points[label])
      label = 0;
  return result;
}

/** Returns the widths of planes [m], as Metrics::by_width describes. */
std::vector<double>
widthsOf (const std::vector<PlaneSegment>& planes)
{
  constexpr double squared_side_over_variance = 12.0; // of a uniform distribution
  std::vector<double> widths;
  for (const PlaneSegment& plane : planes) {
    const std::optional<PlaneFit> fit = fitPlane (plane.moments);
    widths.push_back (fit ? std::sqrt (squared_side_over_variance * fit->variances[1])
                          : 0.0);
  }
  return widths;
}

/** \throw std::invalid_argument if a list has no entry for each point */
void
checkSizes (std::size_t points,
            const PlaneLabels& truth,
            const PlaneLabels& result,
            const std::vector<char>& is_ignored)
{
  const bool have_same_size = truth.size() == points && result.size() == points &&
                              (is_ignored.empty() || is_ignored.size() == points);
  if (!have_same_size)
    throw std::invalid_argument (
        std::to_string (points) + " points, " + std::to_string (truth.size()) +
        " true labels and " + std::to_string (result.size()) +
        " found ones do not belong together" +
        (is_ignored.empty() ? ""
                            : ", with " + std::to_string (is_ignored.size()) +
                                  " marks of what is ignored"));
}

/** Returns Metrics::named. */
NamedValues
namedMetrics (const Confusion& confusion,
              const Matching& at_50,
              const Matching& at_75,
              const std::vector<PlaneSegment>& truth_planes,
              const std::vector<PlaneSegment>& result_planes)
{
  const std::size_t points = confusion.truth.of_point.size();
  const std::size_t assigned = pointsOfAssignment (confusion);
  const std::size_t off_true_planes = confusion.points_off_true_planes;
  const std::size_t off_in_both = confusion.points_on_no_plane_in_both;
  NamedValues named = {
      {"classification_accuracy",
       classificationAccuracy (confusion, truth_planes, result_planes)},
      {"segmentation_accuracy",
       shareOf (assigned, points - off_true_planes, result_planes.empty() ? 1.0 : 0.0)},
      {"segmentation_accuracy_all", shareOf (assigned + off_in_both, points, 1.0)}};
  for (const auto& [name, value] : instanceMetrics (at_50))
    named.emplace_back (name, value);
  for (const auto& [name, value] : instanceMetrics (at_75))
    named.emplace_back (name + "_75", value);
  named.emplace_back ("points_off_planes_called_planes",
                      shareOf (off_true_planes - off_in_both, off_true_planes, 0.0));
  for (const auto& [name, value] : partitionMetrics (confusion))
    named.emplace_back (name, value);
  return named;
}

} // namespace

PlaneLabels
labelsOf (const std::vector<pcl::PointIndices>& planes, std::size_t points)
{
  PlaneLabels labels (points, 0);
  for (std::size_t plane = 0; plane < planes.size(); ++plane)
    for (const pcl::index_t i : planes[plane].indices)
      labels[std::size_t (i)] = std::uint32_t (plane + 1);
  return labels;
}

pcl::Indices
finitePointsOf (const XyzCloud& cloud)
{
  pcl::Indices finite;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (pcl::isXYZFinite (cloud[i]))
      finite.push_back (pcl::index_t (i));
  return finite;
}

PlaneLabels
selectLabels (const PlaneLabels& labels, const pcl::Indices& points)
{
  PlaneLabels selected;
  for (const pcl::index_t i : points)
    selected.push_back (labels[std::size_t (i)]);
  return selected;
}

PlaneIds
planeIds (const PlaneLabels& labels)
{
  std::map<std::uint32_t, std::uint32_t> id_of; // by label
  for (const std::uint32_t label : labels)
    id_of[label] = PlaneIds::none;
  PlaneIds ids;
  for (auto& [label, id] : id_of)
    if (label != 0) {
      id = std::uint32_t (ids.size());
      ids.label.push_back (label);
    }
  ids.points.resize (ids.size());
  for (const std::uint32_t label : labels) {
    ids.of_point.push_back (id_of[label]);
    if (label != 0)
      ++ids.points[ids.of_point.back()];
  }
  return ids;
}

void
dropSmallPlanes (PlaneLabels& labels, std::size_t min_points)
{
  const PlaneIds ids = planeIds (labels);
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (labels[i] != 0 && ids.points[ids.of_point[i]] < min_points)
      labels[i] = 0;
}

std::vector<PlaneSegment>
planesOf (const XyzCloud& cloud, const PlaneIds& ids, const ClassParameters& classes)
{
  std::vector<PlaneSegment> segments (ids.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (ids.of_point[i] == PlaneIds::none)
      continue;
    PlaneSegment& segment = segments[ids.of_point[i]];
    const Vector3d point = cloud[i].getVector3fMap().cast<double>();
    if (segment.inliers.empty())
      segment.moments.origin = point;
    addTo (segment.moments, point);
    segment.inliers.push_back (pcl::index_t (i));
  }
  const Vector3d sensor = cloud.sensor_origin_.head<3>().cast<double>();
  for (PlaneSegment& segment : segments) {
    if (const std::optional<PlaneFit> fit = fitPlane (segment.moments)) {
      const Vector3d& normal = fit->plane.normal;
      segment.normal = fit->plane.distance (sensor) < 0.0 ? -normal : normal;
      segment.orientation = orientationOf (normal, classes.up, classes.tolerance);
    }
    segment.centroid = segment.moments.centroid();
    segment.moments = segment.moments.about (segment.centroid);
  }
  return segments;
}

Confusion
confusionOf (const PlaneLabels& truth, const PlaneLabels& result)
{
  Confusion confusion{planeIds (truth), planeIds (result)};
  using Pair = std::pair<std::uint32_t, std::uint32_t>; // ids in truth and in result
  std::map<Pair, std::size_t> points_of_pair;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (truth[i] == 0)
      ++confusion.points_off_true_planes;
    if (truth[i] == 0 && result[i] == 0)
      ++confusion.points_on_no_plane_in_both;
    if (truth[i] != 0 && result[i] != 0)
      ++points_of_pair[{confusion.truth.of_point[i], confusion.result.of_point[i]}];
  }
  for (const auto& [pair, points] : points_of_pair) {
    const auto [truth_id, result_id] = pair;
    confusion.overlaps.push_back ({truth_id, result_id, points});
  }
  return confusion;
}

Metrics
compareLabels (const XyzCloud& cloud,
               const PlaneLabels& truth,
               const PlaneLabels& result,
               const ClassParameters& parameters,
               const std::vector<char>& is_ignored)
{
  checkSizes (cloud.size(), truth, result, is_ignored);
  const pcl::Indices known = knownOf (finitePointsOf (cloud), is_ignored);
  const XyzCloud points (cloud, known);
  const Confusion confusion =
      confusionOf (selectLabels (truth, known),
                   selectLabels (withoutUnknownPlanes (result, is_ignored), known));
  const Matching at_50 = matchingAt (confusion, 0.50);
  const Matching at_75 = matchingAt (confusion, 0.75);
  const std::vector<PlaneSegment> truth_planes =
      planesOf (points, confusion.truth, parameters);
  const std::vector<PlaneSegment> result_planes =
      planesOf (points, confusion.result, parameters);

  Metrics metrics;
  metrics.points = points.size();
  metrics.truth_planes = confusion.truth.size();
  metrics.result_planes = confusion.result.size();
  metrics.named = namedMetrics (confusion, at_50, at_75, truth_planes, result_planes);
  const std::vector<double> point_counts (confusion.truth.points.begin(),
                                          confusion.truth.points.end());
  metrics.by_size = classesOf (at_50, at_75, point_counts, limits_of_points);
  metrics.by_width = classesOf (at_50, at_75, widthsOf (truth_planes), limits_of_width);
  return metrics;
}

NamedValues
namedCounts (const Metrics& metrics)
{
  NamedValues named;
  const auto add = [&named] (const char* by, const SizeClasses& classes) {
    for (const SizeClass& size : classes) {
      std::ostringstream suffix;
      suffix << "_by_" << by << (size.below ? "_below_" : "_from_")
             << size.below.value_or (size.from);
      named.emplace_back ("planes" + suffix.str(), double (size.planes));
      named.emplace_back ("found" + suffix.str(), double (size.found_50));
      named.emplace_back ("found_75" + suffix.str(), double (size.found_75));
    }
  };
  add ("points", metrics.by_size);
  add ("width", metrics.by_width);
  return named;
}

} // namespace pcl_ops::evaluation
