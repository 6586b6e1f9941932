// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "geometry/angles.h"
#include <pcl_ops/up_axis.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl_ops {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/** \brief The properties of a plane that the estimate uses. */
struct Face {
  Vector3d normal;   // PlaneSegment::normal
  Vector3d centroid; // [m]
  /** \brief Covariance of its points [m^2]. */
  Matrix3d covariance;
  /** \brief Its share of the points on all planes. */
  double share_of_points;
  /** \brief The square root of its number of points, as a share of the sum of these
   * roots over all planes. The number itself would weight near planes too much: a near
   * plane has far more points than a far one of the same size. */
  double weight;
};

/** \brief All planes with finite numbers and points. */
struct Faces {
  std::vector<Face> each;
  /** \brief Mean [m] and covariance [m^2] of the points on all planes. */
  Vector3d mean = Vector3d::Zero();
  Matrix3d covariance = Matrix3d::Zero();
};

bool
isUsable (const PlaneSegment& plane)
{
  return plane.normal.allFinite() && plane.centroid.allFinite() &&
         plane.moments.count > 0.0 && plane.moments.covariance().allFinite();
}

Faces
facesOf (const std::vector<PlaneSegment>& planes)
{
  Faces faces;
  double points = 0.0;
  double weights = 0.0;
  for (const PlaneSegment& plane : planes) {
    if (!isUsable (plane))
      continue;
    const double count = plane.moments.count;
    const double weight = std::sqrt (count);
    const Matrix3d covariance = plane.moments.covariance();
    // The last two members become shares below, once the sums are known.
    faces.each.push_back ({plane.normal, plane.centroid, covariance, count, weight});
    points += count;
    weights += weight;
  }
  for (Face& face : faces.each) {
    face.share_of_points /= points;
    face.weight /= weights;
    faces.mean += face.share_of_points * face.centroid;
  }
  for (const Face& face : faces.each) {
    const Vector3d offset = face.centroid - faces.mean;
    faces.covariance +=
        face.share_of_points * (face.covariance + offset * offset.transpose());
  }
  return faces;
}

/** \brief How well a plane fits a direction (Tukey's biweight): 1 for a deviation of 0,
 * and 0 from the limit on. Deviation and limit are sines of angles. */
double
closeness (double deviation, double limit)
{
  const double ratio = deviation / limit;
  const double below_limit = 1.0 - ratio * ratio;
  return deviation >= limit ? 0.0 : below_limit * below_limit;
}

/** \brief How horizontal a plane is, 0 to 1, if \p axis is vertical.
 * \param[in] limit sine of the angle from which on the result is 0 */
double
levelness (const Face& face, const Vector3d& axis, double limit)
{
  return closeness (face.normal.cross (axis).norm(), limit);
}

/** \brief How vertical a plane is, 0 to 1, if \p axis is vertical.
 * \param[in] limit sine of the angle from which on the result is 0 */
double
uprightness (const Face& face, const Vector3d& axis, double limit)
{
  return closeness (std::abs (face.normal.dot (axis)), limit);
}

/** \brief Refines an axis by iteratively reweighted least squares. The result u fits
 * the planes best: normals n of horizontal planes are along u, normals of vertical
 * planes are perpendicular to u. Each step maximizes the sum over planes of w (h - v)
 * (n . u)^2, with the weight w of the plane. For the u of the step before, h says how
 * horizontal the plane is, v how vertical.
 * \param[in] axis where to start
 * \param[in] tolerance UpAxisParameters::angle_tolerance [rad] */
Vector3d
fittedAxis (const Faces& faces, Vector3d axis, double tolerance)
{
  constexpr double max_angle = 0.5; // of the widened tolerance [rad]
  // Factors of the tolerance, chosen by hand: in the first steps planes at larger
  // angles count, too, and the last steps converge.
  for (const double widening : {3.0, 2.0, 1.0, 1.0, 1.0}) {
    const double limit = std::sin (std::min (widening * tolerance, max_angle));
    Matrix3d scatter = Matrix3d::Zero();
    for (const Face& face : faces.each)
      scatter += face.weight *
                 (levelness (face, axis, limit) - uprightness (face, axis, limit)) *
                 (face.normal * face.normal.transpose());
    const Eigen::SelfAdjointEigenSolver<Matrix3d> solver (scatter);
    const Vector3d best = solver.eigenvectors().col (2); // of the largest eigenvalue
    axis = best.dot (axis) < 0.0 ? Vector3d (-best) : best;
  }
  return axis;
}

/** \brief Returns items in descending order of one of their members. */
template <typename Item>
std::vector<Item>
sortedByDescending (double Item::*value, std::vector<Item> items)
{
  std::stable_sort (items.begin(), items.end(), [=] (const Item& a, const Item& b) {
    return a.*value > b.*value;
  });
  return items;
}

/** \brief Axes to start from: the normals of the largest planes, and the unit cross
 * products of two of these normals at a large enough angle. */
std::vector<Vector3d>
startAxes (const Faces& faces)
{
  constexpr std::size_t max_planes = 12; // they give up to 78 axes; chosen by hand
  constexpr double min_sine = 0.5;       // of the angle between two normals: 30 degrees
  std::vector<Face> largest = sortedByDescending (&Face::weight, faces.each);
  largest.resize (std::min (largest.size(), max_planes));
  std::vector<Vector3d> axes;
  for (std::size_t i = 0; i < largest.size(); ++i) {
    axes.push_back (largest[i].normal);
    for (std::size_t j = 0; j < i; ++j) {
      const Vector3d across = largest[i].normal.cross (largest[j].normal);
      if (across.norm() > min_sine)
        axes.push_back (across.normalized());
    }
  }
  return axes;
}

/** \brief An axis that may be vertical. Either of its two directions may be up. */
struct AxisCandidate {
  Vector3d axis;
  /** \brief Sum of the weights of planes that are horizontal or vertical if the axis is
   * vertical, 0 to 1. */
  double share;
};

/** \brief A direction that may be up. */
struct UpCandidate {
  Vector3d up; // unit vector
  /** \brief Its log-likelihood, \ref evidenceFor. */
  double evidence;
};

/** \brief Axes with enough horizontal and enough vertical planes, the axis with the
 * largest share first. Of axes within 12 degrees of each other only the first one is
 * kept. */
std::vector<AxisCandidate>
candidatesOf (const Faces& faces, const UpAxisParameters& parameters)
{
  constexpr double min_cosine_of_same = 0.978; // of 12 degrees
  const double limit = std::sin (parameters.angle_tolerance);
  std::vector<AxisCandidate> all;
  std::vector<AxisCandidate> distinct;
  for (const Vector3d& start : startAxes (faces)) {
    const Vector3d axis = fittedAxis (faces, start, parameters.angle_tolerance);
    double horizontal = 0.0;
    double vertical = 0.0;
    for (const Face& face : faces.each) {
      horizontal += face.weight * levelness (face, axis, limit);
      vertical += face.weight * uprightness (face, axis, limit);
    }
    if (std::min (horizontal, vertical) >= parameters.min_share)
      all.push_back ({axis, horizontal + vertical});
  }
  for (const AxisCandidate& candidate :
       sortedByDescending (&AxisCandidate::share, std::move (all)))
    if (std::none_of (
            distinct.begin(), distinct.end(), [&] (const AxisCandidate& other) {
              return std::abs (other.axis.dot (candidate.axis)) > min_cosine_of_same;
            }))
      distinct.push_back (candidate);
  return distinct;
}

/** \brief Sum of the weights of the horizontal planes whose normals point up, as of
 * floors, seats and table tops.
 * \param[in] limit sine of the angle from which on planes are not horizontal */
double
facingShare (const Faces& faces, const Vector3d& up, double limit)
{
  double share = 0.0;
  for (const Face& face : faces.each)
    if (face.normal.dot (up) > 0.0)
      share += face.weight * levelness (face, up, limit);
  return share;
}

/** \brief Log-likelihood that a direction is up, but for a constant. It grows with the
 * share of planes that face up, with that of vertical planes, and with the skewness of
 * the points along the direction, positive if most points are low. It decreases with
 * how much the sensor looks along the direction, and with the extent of the points
 * along it. */
double
evidenceFor (const Vector3d& up,
             const Faces& faces,
             const Vector3d& viewpoint,
             double tolerance)
{
  const double limit = std::sin (tolerance);
  double vertical = 0.0;     // sum of the weights of vertical planes
  double third_moment = 0.0; // mean cube of the heights of points above the mean [m^3]
  for (const Face& face : faces.each) {
    vertical += face.weight * uprightness (face, up, limit);
    const double height = up.dot (face.centroid - faces.mean);
    const double variance_of_face = up.dot (face.covariance * up);
    third_moment += face.share_of_points *
                    (height * height * height + 3.0 * height * variance_of_face);
  }
  const double variance = up.dot (faces.covariance * up);
  const double total_variance = faces.covariance.trace();
  const Vector3d gaze = faces.mean - viewpoint; // mean direction of view [m]
  // Share of the gaze that is along the direction, lower for scans in all directions.
  const double gaze_along_up =
      gaze.dot (up) * gaze.dot (up) / (total_variance + gaze.squaredNorm());
  // Points at one height have no skewness. Rounding leaves less than this share of
  // their variance, also below zero.
  constexpr double max_share_by_rounding = 1e-12;
  const double skewness = variance > max_share_by_rounding * total_variance
                              ? third_moment / std::pow (variance, 1.5)
                              : 0.0;
  // Weights by maximum likelihood on 300 simulated rooms, with a weak prior towards 0.
  constexpr double weight_of_facing = 13.0;
  constexpr double weight_of_vertical = 1.5;
  constexpr double weight_of_gaze = 13.0;
  constexpr double weight_of_variance = 11.0;
  constexpr double weight_of_skewness = 0.8;
  constexpr double max_skewness = 2.0;
  return weight_of_facing * facingShare (faces, up, limit) +
         weight_of_vertical * vertical - weight_of_gaze * gaze_along_up -
         weight_of_variance * variance / total_variance +
         weight_of_skewness * std::clamp (skewness, -max_skewness, max_skewness);
}

/** \brief Whether a sensor has looked in all directions and seen floor and ceiling.
 * Then it depends on furniture whether more planes face up or down: their number does
 * not tell which direction is up. */
bool
seesFloorAndCeiling (const Vector3d& up,
                     const Faces& faces,
                     const Vector3d& viewpoint,
                     double tolerance)
{
  // A sensor has looked in all directions if squared_gaze is less than this share of
  // its sum with the variance of the points. For images of cameras the share is 0.6 or
  // more.
  constexpr double max_share_of_gaze = 0.3;
  // Least weight of the planes that face up, and of those that face down; chosen by
  // hand.
  constexpr double min_facing_share = 0.05;
  const double squared_gaze = (faces.mean - viewpoint).squaredNorm();
  const double limit = std::sin (tolerance);
  return squared_gaze < max_share_of_gaze * (squared_gaze + faces.covariance.trace()) &&
         facingShare (faces, up, limit) >= min_facing_share &&
         facingShare (faces, -up, limit) >= min_facing_share;
}

} // namespace

std::string
validate (const UpAxisParameters& parameters)
{
  const auto isShare = [] (double number) { return number >= 0.0 && number <= 1.0; };
  if (!(parameters.angle_tolerance > 0.0 &&
        parameters.angle_tolerance <= internal::max_right_angle))
    return "the angle tolerance must be above 0 and at most pi/2 (radians)";
  if (!isShare (parameters.min_share))
    return "the least share must be a number from 0 to 1";
  if (!isShare (parameters.min_confidence))
    return "the least confidence must be a number from 0 to 1";
  return {};
}

std::optional<UpAxis>
estimateUpAxis (const std::vector<PlaneSegment>& planes,
                const Eigen::Vector3d& viewpoint,
                const UpAxisParameters& parameters)
{
  const Faces faces = facesOf (planes);
  if (faces.each.empty() || !viewpoint.allFinite() || !validate (parameters).empty())
    return std::nullopt;
  std::vector<UpCandidate> candidates;
  for (const AxisCandidate& vertical : candidatesOf (faces, parameters))
    for (const double sign : {1.0, -1.0}) {
      const Vector3d up = sign * vertical.axis;
      candidates.push_back (
          {up, evidenceFor (up, faces, viewpoint, parameters.angle_tolerance)});
    }
  if (candidates.empty())
    return std::nullopt;
  const UpCandidate best =
      *std::max_element (candidates.begin(),
                         candidates.end(),
                         [] (const UpCandidate& first, const UpCandidate& second) {
                           return first.evidence < second.evidence;
                         });
  // The confidence is the likelihood of the best direction over the sum of all.
  double sum_of_likelihood_ratios = 0.0;
  for (const UpCandidate& candidate : candidates)
    sum_of_likelihood_ratios += std::exp (candidate.evidence - best.evidence);
  const UpAxis found{best.up.normalized(), 1.0 / sum_of_likelihood_ratios};
  if (!(found.confidence >= parameters.min_confidence))
    return std::nullopt;
  if (parameters.min_confidence > 0.0 &&
      seesFloorAndCeiling (best.up, faces, viewpoint, parameters.angle_tolerance))
    return std::nullopt;
  return found;
}

} // namespace pcl_ops
