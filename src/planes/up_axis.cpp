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
  Vector3d normal, centroid;
  Matrix3d covariance;
  /** \brief Its share of the points on all planes. */
  double share_of_points;
  /** \brief Its share of the sum over planes of the square root of the number of
   * points: a near plane has far more points than a far one of the same size. */
  double weight;
};

/** \brief All usable planes, with the mean and covariance of their points. */
struct Faces {
  std::vector<Face> each;
  /** \brief Mean of the points on all planes. */
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
    // The last two become shares below, once the sums are known.
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

/** \brief How well a plane fits a direction (Tukey's biweight): 1 for no deviation, 0
 * from the limit on. Both are sines of angles. */
double
closeness (double deviation, double limit)
{
  const double ratio = deviation / limit;
  const double below_limit = 1.0 - ratio * ratio;
  return deviation >= limit ? 0.0 : below_limit * below_limit;
}

/** \brief How horizontal a plane is if \p axis is up. */
double
levelness (const Face& face, const Vector3d& axis, double limit)
{
  return closeness (face.normal.cross (axis).norm(), limit);
}

/** \brief How vertical a plane is if \p axis is up. */
double
uprightness (const Face& face, const Vector3d& axis, double limit)
{
  return closeness (std::abs (face.normal.dot (axis)), limit);
}

/** \brief Refines an axis by iteratively reweighted least squares. Its direction u fits
 * the planes best: normals n of horizontal planes are along it, those of vertical
 * planes across it. It maximizes the sum of w_h (n . u)^2 - w_v (n . u)^2, where the
 * weights w_h and w_v say how horizontal and how vertical a plane is for the u of the
 * step before. */
Vector3d
fittedAxis (const Faces& faces, Vector3d axis, double tolerance)
{
  // Factors of the tolerance: at first planes farther off count, too.
  for (const double widening : {3.0, 2.0, 1.0, 1.0, 1.0}) {
    constexpr double max_angle = 0.5; // [rad]
    const double limit = std::sin (std::min (widening * tolerance, max_angle));
    Matrix3d scatter = Matrix3d::Zero();
    for (const Face& face : faces.each)
      scatter += face.weight *
                 (levelness (face, axis, limit) - uprightness (face, axis, limit)) *
                 (face.normal * face.normal.transpose());
    const Eigen::SelfAdjointEigenSolver<Matrix3d> solver (scatter);
    const Vector3d best = solver.eigenvectors().col (2);
    axis = best.dot (axis) < 0.0 ? Vector3d (-best) : best;
  }
  return axis;
}

/** \brief Returns items in descending order of one of their members. */
template <typename Item>
std::vector<Item>
sorted (std::vector<Item> items, double Item::*value)
{
  std::stable_sort (items.begin(), items.end(), [=] (const Item& a, const Item& b) {
    return a.*value > b.*value;
  });
  return items;
}

/** \brief Normals of the largest planes, and cross products of two of them at a large
 * enough angle. */
std::vector<Vector3d>
axesToTry (const Faces& faces)
{
  constexpr std::size_t max_planes = 12;
  constexpr double min_sine = 0.5;
  std::vector<Face> largest = sorted (faces.each, &Face::weight);
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

/** \brief An axis that may be vertical; which of its ends is up is open. */
struct AxisCandidate {
  Vector3d axis;
  /** \brief Weight of planes that are horizontal or vertical for the axis, 0 to 1. */
  double share;
};

/** \brief A direction that may be up. */
struct UpCandidate {
  Vector3d up;
  /** \brief Log-likelihood by \ref evidenceFor. */
  double evidence;
};

/** \brief Axes with enough horizontal and enough vertical planes, each axis once. */
std::vector<AxisCandidate>
candidatesOf (const Faces& faces, const UpAxisParameters& parameters)
{
  constexpr double same_axis = 0.978; // cosine of 12 degrees
  const double limit = std::sin (parameters.angle_tolerance);
  std::vector<AxisCandidate> all;
  std::vector<AxisCandidate> distinct;
  for (const Vector3d& start : axesToTry (faces)) {
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
  for (const AxisCandidate& candidate : sorted (std::move (all), &AxisCandidate::share))
    if (std::none_of (
            distinct.begin(), distinct.end(), [&] (const AxisCandidate& other) {
              return std::abs (other.axis.dot (candidate.axis)) > same_axis;
            }))
      distinct.push_back (candidate);
  return distinct;
}

/** \brief Weight of the planes that face up (floor, seat, table top) for a given up. */
double
facingShare (const Faces& faces, const Vector3d& up, double limit)
{
  double share = 0.0;
  for (const Face& face : faces.each)
    if (face.normal.dot (up) > 0.0)
      share += face.weight * levelness (face, up, limit);
  return share;
}

/** \brief Log-likelihood of a direction to be up, but for a constant. */
double
evidenceFor (const Vector3d& up,
             const Faces& faces,
             const Vector3d& viewpoint,
             double tolerance)
{
  const double limit = std::sin (tolerance);
  double vertical = 0.0;
  double third_moment = 0.0;
  for (const Face& face : faces.each) {
    vertical += face.weight * uprightness (face, up, limit);
    const double height = up.dot (face.centroid - faces.mean);
    const double variance = up.dot (face.covariance * up);
    third_moment +=
        face.share_of_points * (height * height * height + 3.0 * height * variance);
  }
  const double variance = up.dot (faces.covariance * up);
  const double total_variance = faces.covariance.trace();
  const Vector3d gaze = faces.mean - viewpoint;
  const double along_gaze =
      gaze.dot (up) * gaze.dot (up) / (total_variance + gaze.squaredNorm());
  const double skewness = third_moment / std::pow (variance, 1.5);
  // Weights by maximum likelihood on 300 simulated rooms, with a weak prior towards 0.
  return 13.0 * facingShare (faces, up, limit) + 1.5 * vertical - 13.0 * along_gaze -
         11.0 * variance / total_variance + 0.8 * std::clamp (skewness, -2.0, 2.0);
}

/** \brief Whether a scan in all directions has seen floor and ceiling. Then furniture
 * decides whether more planes face up or down, so that their number does not tell up.
 */
bool
seesFloorAndCeiling (const Vector3d& up,
                     const Faces& faces,
                     const Vector3d& viewpoint,
                     double tolerance)
{
  // A scan looks in all directions if squared_gaze is less than this share of its sum
  // with the variance of the points: images of cameras have 0.6 and more.
  constexpr double min_directedness = 0.3;
  constexpr double min_share = 0.05;
  const double squared_gaze = (faces.mean - viewpoint).squaredNorm();
  const double limit = std::sin (tolerance);
  return squared_gaze < min_directedness * (squared_gaze + faces.covariance.trace()) &&
         facingShare (faces, up, limit) >= min_share &&
         facingShare (faces, -up, limit) >= min_share;
}

} // namespace

std::string
validate (const UpAxisParameters& parameters)
{
  const auto is_share = [] (double number) { return number >= 0.0 && number <= 1.0; };
  if (!(parameters.angle_tolerance > 0.0 &&
        parameters.angle_tolerance <= internal::right_angle))
    return "the angle tolerance must be above 0 and at most pi/2 (radians)";
  if (!is_share (parameters.min_share))
    return "the least share must be a number from 0 to 1";
  if (!is_share (parameters.min_confidence))
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
  std::vector<UpCandidate> directions;
  for (const AxisCandidate& candidate : candidatesOf (faces, parameters))
    for (const double sign : {1.0, -1.0}) {
      const Vector3d up = sign * candidate.axis;
      directions.push_back (
          {up, evidenceFor (up, faces, viewpoint, parameters.angle_tolerance)});
    }
  if (directions.empty())
    return std::nullopt;
  const UpCandidate best = *std::max_element (
      directions.begin(), directions.end(), [] (const auto& first, const auto& second) {
        return first.evidence < second.evidence;
      });
  double likelihoods = 0.0;
  for (const UpCandidate& direction : directions)
    likelihoods += std::exp (direction.evidence - best.evidence);
  const UpAxis found{best.up.normalized(), 1.0 / likelihoods};
  if (!(found.confidence >= parameters.min_confidence))
    return std::nullopt;
  if (parameters.min_confidence > 0.0 &&
      seesFloorAndCeiling (best.up, faces, viewpoint, parameters.angle_tolerance))
    return std::nullopt;
  return found;
}

} // namespace pcl_ops
