// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/memory.h>
#include <pcl/types.h>

#include <Eigen/Core>

#include <pcl_ops/cloud_view.h>
#include <pcl_ops/export.h>
#include <pcl_ops/orientation.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace pcl_ops {

/** \brief Count, sum and sum of outer products of a set of points: all that a least
 * squares plane fit needs. The sums are taken about \ref origin, which should lie near
 * the points: then they are exact enough for clouds 10^6 m from the frame's zero. */
struct PCL_OPS_EXPORT Moments {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  double count = 0.0; // number of points
  /** \brief Sum of the points, relative to \ref origin. */
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  /** \brief Sums over the points of xx xy xz yy yz zz, relative to \ref origin. */
  std::array<double, 6> products{};

  /** \brief Returns the moments of \p count points from their mean and population
   * covariance, with the mean as origin. */
  static Moments
  of (double count, const Eigen::Vector3d& mean, const Eigen::Matrix3d& covariance);

  /** \brief Adds a point given relative to \ref origin. */
  void
  add (double x, double y, double z)
  {
    count += 1.0;
    sum += Eigen::Vector3d (x, y, z);
    products[0] += x * x;
    products[1] += x * y;
    products[2] += x * z;
    products[3] += y * y;
    products[4] += y * z;
    products[5] += z * z;
  }

  /** \brief Adds another set whose sums are taken about the same origin. */
  void
  addAligned (const Moments& other)
  {
    count += other.count;
    sum += other.sum;
    for (std::size_t i = 0; i < products.size(); ++i)
      products[i] += other.products[i];
  }

  /** \brief Adds another set, whose sums are shifted to this origin if its own origin
   * differs. If this set has no points, it becomes a copy of the other one. */
  Moments&
  operator+= (const Moments& other);

  /** \brief Returns the moments of the same points, taken about another origin. */
  Moments
  about (const Eigen::Vector3d& new_origin) const;

  /** \brief Mean of the points in the frame of \ref origin; undefined for count 0. */
  Eigen::Vector3d
  centroid () const
  {
    return origin + sum / count;
  }

  /** \brief Population covariance about the centroid; undefined for count 0. */
  Eigen::Matrix3d
  covariance () const
  {
    const double scale = 1.0 / count;
    const Eigen::Vector3d mean = scale * sum; // relative to origin
    Eigen::Matrix3d result;
    result (0, 0) = scale * products[0] - mean.x() * mean.x();
    result (0, 1) = result (1, 0) = scale * products[1] - mean.x() * mean.y();
    result (0, 2) = result (2, 0) = scale * products[2] - mean.x() * mean.z();
    result (1, 1) = scale * products[3] - mean.y() * mean.y();
    result (1, 2) = result (2, 1) = scale * products[4] - mean.y() * mean.z();
    result (2, 2) = scale * products[5] - mean.z() * mean.z();
    return result;
  }
};

/** \brief The plane normal . x + offset = 0 with a unit normal. */
struct Plane {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  double offset = 0.0;

  /** \brief Signed distance of a point [m]. */
  double
  distance (const Eigen::Vector3d& point) const
  {
    return normal.dot (point) + offset;
  }
};

namespace detail {

/** \brief Mean squared distance of points to a plane [m^2]; undefined for count 0. */
inline double
meanSquaredDistance (const Moments& moments, const Plane& plane)
{
  const Eigen::Vector3d& n = plane.normal;
  const std::array<double, 6>& m = moments.products;
  const double offset = plane.distance (moments.origin);
  const double second_moment = // along the normal
      n.x() * n.x() * m[0] + n.y() * n.y() * m[3] + n.z() * n.z() * m[5] +
      2.0 * (n.x() * n.y() * m[1] + n.x() * n.z() * m[2] + n.y() * n.z() * m[4]);
  const double squared =
      (second_moment + 2.0 * offset * n.dot (moments.sum)) / moments.count +
      offset * offset;
  return std::max (0.0, squared);
}

} // namespace detail

/** \brief A least squares plane, with the centroid and the variances of its points. */
struct PlaneFit {
  Plane plane;
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  /** \brief Variances along the principal axes, ascending and never negative [m^2]. The
   * first is the squared rms distance of the points to the plane. */
  Eigen::Vector3d variances = Eigen::Vector3d::Zero();
};

/** \brief Fits the plane with the smallest sum of squared distances, from the centered
 * covariance in double precision. The sign of the normal is arbitrary.
 * \return nothing if there are fewer than three points, or if all points are equal or
 * on one line, also if only the rounding of sums about a remote \ref Moments::origin
 * makes them differ */
PCL_OPS_EXPORT std::optional<PlaneFit>
fitPlane (const Moments& moments);

/** \brief The plane through \p point with unit normal \p normal. */
inline Plane
planeThrough (const Eigen::Vector3d& point, const Eigen::Vector3d& normal)
{
  return Plane{normal, -normal.dot (point)};
}

/** \brief For each element (point, voxel or plane) of a list, the index of its plane in
 * a list of planes, or \ref no_plane. */
using Labels = std::vector<std::int32_t>;

constexpr std::int32_t no_plane = -1;

/** \brief Decides which plane gets a point that is within theta_h of several unbounded
 * planes. */
enum class AssignmentRule {
  /** \brief The nearest plane; the first one if two are equally near. */
  Nearest,
  /** \brief The first plane in the list. */
  First
};

/** \brief A detected plane with the points on it, in the frame of the input cloud. */
struct PCL_OPS_EXPORT PlaneSegment {
  /** \brief Mean of the inliers. If the plane is not fitted to all inliers, the mean is
   * projected onto the plane: with 3D-KHT's paper preset, and in clouds with duplicate
   * points that counted once in the fit. */
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  /** \brief Unit normal towards the sensor's origin. If that is 0 0 0 but the points
   * were not seen from it, normals of non-vertical planes point up (turnUnseenUp). */
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  Orientation orientation = Orientation::Other;
  /** \brief Moments of the inliers, taken about \ref centroid. */
  Moments moments;
  /** \brief Ascending indices into the input cloud. */
  pcl::Indices inliers;
  /** \brief Noise of the points on the plane [m]: the median, over the inliers, of the
   * rms distance of a point's neighborhood to a local plane fit. The neighborhoods are
   * large enough to hold independent errors. The noise of a point is at most 4 times
   * the usual noise at its point density. Only Sampling::Neighborhoods sets it, and
   * Sampling::Automatic without a voxel size. Exact points have no noise. Points count
   * as exact if they err by less than about a hundredth of their spacing: their noise
   * is 0, or .7 of the usual noise of others. Without a distance threshold and a
   * merging distance, \ref rms is at most 12 times this value or .002 of the plane's
   * width, whichever is larger. */
  std::optional<double> noise = std::nullopt;

  Plane
  plane () const
  {
    return planeThrough (centroid, normal);
  }

  /** \brief Root mean square distance of the inliers to the plane, from \ref moments
   * [m]; 0 without inliers. */
  double
  rms () const;

  /** \brief Translates the plane, if its cloud is translated by the same shift. */
  void
  moveBy (const Eigen::Vector3d& shift)
  {
    centroid += shift;
    moments.origin += shift;
  }
};

/** \brief Returns the angle between two planes, 0 to pi/2 [rad]. It is exact for nearly
 * parallel planes, too. */
inline double
angleBetween (const PlaneSegment& first, const PlaneSegment& second)
{
  return slopeOf (first.normal, second.normal);
}

/** \brief Uncertainty of a fitted plane: the covariance of its parameter errors. */
struct PlaneCovariance {
  /** \brief Columns u and v: unit vectors in the plane with u x v = normal, the same as
   * in PlaneFrame. They depend only on the normal. */
  Eigen::Matrix<double, 3, 2> axes;
  /** \brief Covariance of the errors of (tilt along u [rad], tilt along v [rad], offset
   * [m]). With errors (a, b, c) the true surface has the height c + a s + b t over the
   * fitted plane at centroid + s u + t v. So the surface has the direction normal - a u
   * - b v as normal, and lies c before the centroid, along the normal of the plane. */
  Eigen::Matrix3d matrix;
};

/** \brief Returns the covariance of the parameters of a plane whose inliers have
 * independent errors, from their moments. For depth cameras call \ref planeCovariance.
 *
 * It is the covariance of a least squares fit of heights over the plane: matrix = v
 * (A^T A)^-1, where A has a row (s, t, 1) for each inlier and the residual variance is
 * v = rms^2 n / (n - 3). It holds for noise along the normal that is independent from
 * point to point. In images of depth cameras neighbors have similar errors, and the
 * true errors of planes are some 7 times larger.
 * \return nothing if there are fewer than four inliers, or if all inliers are equal or
 * on one line */
PCL_OPS_EXPORT std::optional<PlaneCovariance>
independentPlaneCovariance (const PlaneSegment& plane);

/** \brief Returns the covariance of the parameters of a plane whose neighboring points
 * have similar errors, or whose noise grows with the depth, as in depth images.
 *
 * The plane is divided into some 64 square blocks. Residuals h of different blocks
 * count as independent, residuals of one block do not: with g the sum of (s, t, 1) h in
 * each of B blocks, matrix = f^2 B / (B - 3) (A^T A)^-1 (sum of g g^T) (A^T A)^-1 (the
 * cluster-robust covariance of Liang & Zeger, 1986). rms^2 / matrix (2, 2) is the
 * effective number of points. f = 1.7 is measured: frames cut a surface out
 * differently, and errors as long as the plane are fitted. The normalized errors |z| of
 * planes matched over exact poses then have a median of 0.53 to 0.75 (0.67 for a normal
 * distribution).
 * \param[in] cloud the input cloud of the detection, in the frame of the plane
 * \return nothing if \ref independentPlaneCovariance returns nothing, or the inliers
 * lie in fewer than four blocks
 * \throw std::invalid_argument if an inlier lies outside the cloud */
PCL_OPS_EXPORT std::optional<PlaneCovariance>
planeCovariance (const CloudView& cloud, const PlaneSegment& plane);

/** \brief Sets the orientations of planes for another up axis.
 * \param[in,out] planes only \ref PlaneSegment::orientation changes
 * \param[in] up against gravity, any length but 0
 * \param[in] tolerance as in \ref orientationOf, 0 to pi/2 [rad]
 * \return false if \p up or \p tolerance is out of range: no plane is changed then */
PCL_OPS_EXPORT bool
nameOrientations (std::vector<PlaneSegment>& planes,
                  const Eigen::Vector3d& up,
                  double tolerance);

} // namespace pcl_ops
