// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "edges/meetings.h"

#include "edges/point_raster.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace pcl_ops::internal {

namespace {

/** \brief A plane with its points, and how fine they are. */
struct Body {
  PlaneFrame frame;
  PointRaster raster;
  double rms;
  /** \brief Mean distance between neighboring points [m]. */
  double spacing;

  PlanarLine
  inPlane (const Line& line) const
  {
    const Eigen::Vector2d origin = frame.toPlane (line.origin);
    return {origin, frame.toPlane (line.at (1.0)) - origin};
  }
};

/** \brief Mean distance between points spread evenly over a rectangle, whose sides are
 * the roots of 12 times its variances. */
double
spacingOf (const PlaneFit& fit, double points)
{
  constexpr double of_uniform = 12.0;
  const double area = of_uniform * std::sqrt (fit.variances[1] * fit.variances[2]);
  return std::sqrt (area / points);
}

std::vector<std::optional<Body>>
bodiesOf (const CloudView& cloud,
          const std::vector<PlaneSegment>& planes,
          const Eigen::Vector3d& shift)
{
  std::vector<std::optional<Body>> bodies;
  for (const PlaneSegment& plane : planes) {
    bodies.emplace_back();
    const std::optional<PlaneFit> fit = fitPlane (plane.moments);
    if (!fit)
      continue;
    const PlaneFrame in_cloud (plane.centroid - shift, plane.normal);
    bodies.back() = Body{PlaneFrame (plane.centroid, plane.normal),
                         PointRaster (pointsOnPlane (cloud, plane, in_cloud)),
                         std::sqrt (std::max (0.0, fit->variances[0])),
                         spacingOf (*fit, plane.moments.count)};
  }
  return bodies;
}

/** \brief Noise leaves points within so many standard deviations of two planes to
 * either, and so a strip beside their line without points of one. */
double
reachOf (const Body& first, const Body& second, double sine)
{
  constexpr double deviations = 3.0;
  constexpr double spacings = 4.0;
  return deviations * std::hypot (first.rms, second.rms) / sine +
         spacings * std::max (first.spacing, second.spacing);
}

bool
areNear (const Body& first, const Body& second, double reach)
{
  const double apart = (first.frame.toSpace (first.raster.center()) -
                        second.frame.toSpace (second.raster.center()))
                           .norm();
  return apart <= first.raster.radius() + second.raster.radius() + 2.0 * reach;
}

/** \brief The intervals along which both have points. */
Intervals
sharedIntervals (const Body& first,
                 const Body& second,
                 const Line& line,
                 double reach,
                 double max_gap,
                 double min_length)
{
  const auto intervalsBeside = [&] (const Body& body) {
    Intervals intervals =
        intervalsOf (body.raster.placesBeside (body.inPlane (line), reach), max_gap);
    const auto is_short = [&] (const Interval& interval) {
      return interval.length() < min_length;
    };
    intervals.erase (std::remove_if (intervals.begin(), intervals.end(), is_short),
                     intervals.end());
    return intervals;
  };
  // The smaller plane first: mostly it is not there, and the larger need not be asked.
  const bool is_first_smaller = first.raster.size() < second.raster.size();
  const Intervals of_smaller = intervalsBeside (is_first_smaller ? first : second);
  if (of_smaller.empty())
    return {};
  return inCommon (
      of_smaller, intervalsBeside (is_first_smaller ? second : first), min_length);
}

/** \brief What findPlaneEdges is asked for. */
struct Question {
  const std::vector<PlaneSegment>& planes;
  const PlaneEdgeParameters& parameters;
  const std::vector<std::optional<Body>> bodies;

  std::optional<Meeting>
  meetingOf (std::size_t first, std::size_t second) const
  {
    constexpr double reaches_of_gap = 2.0;
    constexpr double reaches_of_length = 3.0;
    const double angle = angleBetween (planes[first], planes[second]);
    if (!bodies[first] || !bodies[second])
      return {};
    const double reach = parameters.reach.value_or (
        reachOf (*bodies[first], *bodies[second], std::sin (angle)));
    if (!areNear (*bodies[first], *bodies[second], reach))
      return {};
    const std::optional<Line> line =
        meetingLine (planes[first], planes[second], std::sin (parameters.min_angle));
    if (!line)
      return {};
    const double gap = parameters.max_gap.value_or (reaches_of_gap * reach);
    const double length = parameters.min_length.value_or (reaches_of_length * reach);
    Intervals intervals =
        sharedIntervals (*bodies[first], *bodies[second], *line, reach, gap, length);
    if (intervals.empty())
      return {};
    return Meeting{first, second, *line, angle, gap, std::move (intervals)};
  }
};

} // namespace

std::vector<Meeting>
meetingsOf (const CloudView& cloud,
            const std::vector<PlaneSegment>& planes,
            const PlaneEdgeParameters& parameters,
            const Eigen::Vector3d& shift)
{
  const Question question{planes, parameters, bodiesOf (cloud, planes, shift)};
  std::vector<Meeting> meetings;
  for (std::size_t i = 0; i < planes.size(); ++i)
    for (std::size_t j = i + 1; j < planes.size(); ++j)
      if (std::optional<Meeting> meeting = question.meetingOf (i, j))
        meetings.push_back (std::move (*meeting));
  return meetings;
}

} // namespace pcl_ops::internal
