// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "edges/plane_meeting.h"

#include <Eigen/Dense>

#include <cmath>

namespace pcl_ops::internal {

namespace {

/** \brief Signed distance of a point, exact far from zero where offsets are not. */
double
distanceOf (const Eigen::Vector3d& point, const PlaneSegment& plane)
{
  return plane.normal.dot (point - plane.centroid);
}

bool
isAcross (const Line& line, const PlaneSegment& plane, double min_sine)
{
  return std::abs (line.direction.dot (plane.normal)) >= min_sine;
}

} // namespace

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
  const double d1 = distanceOf (middle, first);
  const double d2 = distanceOf (middle, second);
  const double a = (c * d2 - d1) / (sine * sine);
  const double b = (c * d1 - d2) / (sine * sine);
  return Line{middle + a * first.normal + b * second.normal, along / sine};
}

std::optional<Eigen::Vector3d>
meetingPoint (const PlaneSegment& first,
              const PlaneSegment& second,
              const PlaneSegment& third,
              double min_sine)
{
  const std::optional<Line> line = meetingLine (first, second, min_sine);
  const std::optional<Line> next = meetingLine (second, third, min_sine);
  const std::optional<Line> last = meetingLine (third, first, min_sine);
  if (!line || !next || !last || !isAcross (*line, third, min_sine) ||
      !isAcross (*next, first, min_sine) || !isAcross (*last, second, min_sine))
    return {};
  const Eigen::Vector3d middle =
      (first.centroid + second.centroid + third.centroid) / 3.0;
  Eigen::Matrix3d normals;
  normals << first.normal.transpose(), second.normal.transpose(),
      third.normal.transpose();
  const Eigen::Vector3d distances (distanceOf (middle, first),
                                   distanceOf (middle, second),
                                   distanceOf (middle, third));
  return middle - normals.partialPivLu().solve (distances);
}

} // namespace pcl_ops::internal
