// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "edges/meetings.h"

#include <Eigen/Geometry>

#include "geometry/planar_area.h"
#include <pcl_ops/plane_extent.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace pcl_ops::internal {

namespace {

/** \brief A plane with its points, and how fine they are. */
struct Body {
  PlaneFrame frame;
  PlanarPoints points;
  /** \brief Around those that are finite. */
  Eigen::AlignedBox2d box;
  double rms;
  /** \brief Mean distance between neighboring points [m]. */
  double spacing;
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

std::optional<Body>
bodyOf (const CloudView& cloud, const PlaneSegment& plane, const Eigen::Vector3d& shift)
{
  const std::optional<PlaneFit> fit = fitPlane (plane.moments);
  if (!fit)
    return {};
  const PlaneFrame in_cloud (plane.centroid - shift, plane.normal);
  Body body{PlaneFrame (plane.centroid, plane.normal),
            pointsOnPlane (cloud, plane, in_cloud),
            {},
            std::sqrt (std::max (0.0, fit->variances[0])),
            spacingOf (*fit, plane.moments.count)};
  for (const Eigen::Vector2d& point : body.points)
    if (point.allFinite())
      body.box.extend (point);
  return body;
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

/** \brief Of circles around all points. */
bool
areNear (const Body& first, const Body& second, double reach)
{
  const double apart = (first.frame.toSpace (first.box.center()) -
                        second.frame.toSpace (second.box.center()))
                           .norm();
  const double diameters = first.box.diagonal().norm() + second.box.diagonal().norm();
  return apart <= 0.5 * diameters + 2.0 * reach;
}

/** \brief The line that two planes have in common, with its origin next to the middle
 * of their centroids.
 * \param[in] min_sine nothing for planes at an angle with a smaller sine */
std::optional<Line>
meetingLine (const PlaneSegment& first, const PlaneSegment& second, double min_sine)
{
  const Eigen::Vector3d along = first.normal.cross (second.normal);
  const double sine = along.norm();
  const Eigen::Vector3d middle = 0.5 * (first.centroid + second.centroid);
  if (!(sine >= min_sine && sine > 0.0) || !middle.allFinite())
    return {};
  // [1 c; c 1] [a b]^T = -[d1 d2]^T with c = n1 . n2 and distances d of the middle
  const double c = first.normal.dot (second.normal);
  const double d1 = signedDistance (middle, first);
  const double d2 = signedDistance (middle, second);
  const double a = (c * d2 - d1) / (sine * sine);
  const double b = (c * d1 - d2) / (sine * sine);
  return Line{middle + a * first.normal + b * second.normal, along / sine};
}

/** \brief Where along a line of the plane its points beside the line are. */
std::vector<double>
placesBeside (const Body& body, const Line& line, double reach)
{
  const Eigen::Vector2d origin = body.frame.toPlane (line.origin);
  const Eigen::Vector2d along = body.frame.toPlane (line.at (1.0)) - origin;
  const double radius = 0.5 * body.box.diagonal().norm();
  if (std::abs (cross (along, body.box.center() - origin)) > radius + reach)
    return {};
  std::vector<double> places;
  for (const Eigen::Vector2d& point : body.points)
    if (std::abs (cross (along, point - origin)) <= reach)
      places.push_back (along.dot (point - origin));
  return places;
}

/** \brief What findPlaneEdges is asked for. */
struct Question {
  const std::vector<PlaneSegment>& planes;
  const PlaneEdgeParameters& parameters;
  std::vector<std::optional<Body>> bodies;

  std::optional<Meeting>
  meetingOf (std::size_t first, std::size_t second) const
  {
    constexpr double reaches_of_gap = 2.0;
    constexpr double reaches_of_length = 3.0;
    if (!bodies[first] || !bodies[second])
      return {};
    const Body &one = *bodies[first], &other = *bodies[second];
    const double angle = angleBetween (planes[first], planes[second]);
    const double reach =
        parameters.reach.value_or (reachOf (one, other, std::sin (angle)));
    if (!areNear (one, other, reach))
      return {};
    const std::optional<Line> line =
        meetingLine (planes[first], planes[second], std::sin (parameters.min_angle));
    if (!line)
      return {};
    const double gap = parameters.max_gap.value_or (reaches_of_gap * reach);
    const double length = parameters.min_length.value_or (reaches_of_length * reach);
    // The smaller plane first: mostly it is not there, and the larger need not be
    // asked.
    const bool is_first_smaller = one.points.size() < other.points.size();
    const Body &smaller = is_first_smaller ? one : other,
               &larger = is_first_smaller ? other : one;
    Intervals common = intervalsOf (placesBeside (smaller, *line, reach), gap);
    if (!common.empty())
      common = inCommon (
          common, intervalsOf (placesBeside (larger, *line, reach), gap), length);
    if (common.empty())
      return {};
    return Meeting{first, second, *line, angle, gap, std::move (common)};
  }
};

} // namespace

std::vector<Meeting>
meetingsOf (const CloudView& cloud,
            const std::vector<PlaneSegment>& planes,
            const PlaneEdgeParameters& parameters,
            const Eigen::Vector3d& shift)
{
  Question question{planes, parameters, {}};
  for (const PlaneSegment& plane : planes)
    question.bodies.push_back (bodyOf (cloud, plane, shift));
  std::vector<Meeting> meetings;
  for (std::size_t i = 0; i < planes.size(); ++i)
    for (std::size_t j = i + 1; j < planes.size(); ++j)
      if (std::optional<Meeting> meeting = question.meetingOf (i, j))
        meetings.push_back (std::move (*meeting));
  return meetings;
}

} // namespace pcl_ops::internal
