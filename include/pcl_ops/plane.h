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
 * squares plane needs. The sums are taken about \ref origin, which should lie near the
 * points: that keeps them exact enough for clouds 10^6 m from the frame's zero. */
struct PCL_OPS_EXPORT Moments {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  double count = 0.0;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  /** \brief xx xy xz yy yz zz */
  std::array<double, 6> products{};

  /** \brief Of points of which only mean and population covariance are known. */
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

  /** \brief Adds another set; its sums are shifted if its origin differs. A set without
   * points becomes the other one, with its origin. */
  Moments&
  operator+= (const Moments& other);

  /** \brief The same set of points with its sums taken about another origin. */
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
    const Eigen::Vector3d mean = scale * sum;
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
  const double second =
      n.x() * n.x() * m[0] + n.y() * n.y() * m[3] + n.z() * n.z() * m[5] +
      2.0 * (n.x() * n.y() * m[1] + n.x() * n.z() * m[2] + n.y() * n.z() * m[4]);
  const double squared =
      (second + 2.0 * offset * n.dot (moments.sum)) / moments.count + offset * offset;
  return std::max (0.0, squared);
}

} // namespace detail

/** \brief A least squares plane with what its fit says about the points. */
struct PlaneFit {
  Plane plane;
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  /** \brief Variances along the principal axes, ascending [m^2]. The first is the
   * squared rms distance of the points to the plane. */
  Eigen::Vector3d variances = Eigen::Vector3d::Zero();
};

/** \brief The plane with the smallest sum of squared distances (centered, in double).
 * \return nothing for fewer than three points, for a line or all equal ones */
PCL_OPS_EXPORT std::optional<PlaneFit>
fitPlane (const Moments& moments);

/** \brief The plane through \p point with unit normal \p normal. */
inline Plane
planeThrough (const Eigen::Vector3d& point, const Eigen::Vector3d& normal)
{
  return Plane{normal, -normal.dot (point)};
}

/** \brief The plane of each point, voxel or plane of a list: a position in a list of
 * planes, or \ref no_plane. */
using Labels = std::vector<std::int32_t>;

constexpr std::int32_t no_plane = -1;

/** \brief Which of the unbounded planes within theta_h gets a point. */
enum class AssignmentRule {
  /** \brief The nearest; of two equally near ones the first. */
  Nearest,
  /** \brief The first of the list. */
  First
};

/** \brief A detected plane with the points on it, in the frame of the input cloud. */
struct PCL_OPS_EXPORT PlaneSegment {
  /** \brief Mean of the inliers; of a plane that is not fitted to them, as of 3D-KHT's
   * paper preset or where equal points counted once, taken onto it along the normal. */
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  /** \brief Unit normal towards the sensor's origin. Where a cloud says 0 0 0 and was
   * not seen from there, normals point up, but for vertical planes (turnUnseenUp). */
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  Orientation orientation = Orientation::Other;
  /** \brief Moments of the inliers, taken about \ref centroid. */
  Moments moments;
  /** \brief Ascending indices into the input cloud. */
  pcl::Indices inliers;
  /** \brief The noise of the plane's surroundings [m]: how far points scatter about the
   * surface through them and those around them, in neighborhoods large enough to hold
   * independent errors; the median over the plane, and at most 4 times what is usual
   * where points are as dense. Known with Sampling::Neighborhoods, and with
   * Sampling::Automatic if it has no voxel size; not of exact points. The \ref rms is
   * at most 12 times this, or .002 of the plane's width if that is more, where no
   * threshold and no merging distance is given. */
  std::optional<double> noise = std::nullopt;

  Plane
  plane () const
  {
    return planeThrough (centroid, normal);
  }

  /** \brief Root mean square distance of the inliers to the plane [m]. */
  double
  rms () const;

  /** \brief Moves the plane by a shift, as its cloud was or will be moved. */
  void
  moveBy (const Eigen::Vector3d& shift)
  {
    centroid += shift;
    moments.origin += shift;
  }
};

/** \brief The angle at which two planes meet, 0 to pi/2 [rad]; exact where they are
 * nearly parallel, too. */
inline double
angleBetween (const PlaneSegment& first, const PlaneSegment& second)
{
  return slopeOf (first.normal, second.normal);
}

/** \brief How far the fit of a plane may be from the surface it is of. */
struct PlaneCovariance {
  /** \brief u and v, as columns: unit vectors in the plane with u x v = normal, those
   * of PlaneFrame. They depend on the normal alone. */
  Eigen::Matrix<double, 3, 2> axes;
  /** \brief Covariance of the errors of (tilt along u [rad], tilt along v [rad], offset
   * [m]). With errors (a, b, c) the surface has the height c + a s + b t over the plane
   * at centroid + s u + t v: its normal is that of the plane - a u - b v, and c is how
   * far it lies before the centroid, along the normal. */
  Eigen::Matrix3d matrix;
};

/** \brief Covariance of the parameters of a plane whose inliers err independently of
 * each other, from their moments and noise. For depth cameras call \ref
 * planeCovariance.
 *
 * The normal equations of heights over the plane, A with a row (s, t, 1) for each
 * inlier: matrix = v (A^T A)^-1 with the residual variance v = rms^2 n / (n - 3). It is
 * right for noise along the normal that is independent from point to point; in images
 * of depth cameras neighbors err alike, and errors are some 7 times larger than it
 * says.
 * \return nothing for fewer than four inliers, for a line or all equal ones */
PCL_OPS_EXPORT std::optional<PlaneCovariance>
independentPlaneCovariance (const PlaneSegment& plane);

/** \brief Covariance of the parameters of a plane where neighboring points err alike or
 * the noise grows with the depth, as in images of depth cameras.
 *
 * The plane is divided into some 64 square blocks, and the residuals h are taken as
 * independent from block to block only: with g the sum of (s, t, 1) h in each of B
 * blocks, matrix = f^2 B / (B - 3) (A^T A)^-1 (sum of g g^T) (A^T A)^-1 (the
 * cluster-robust covariance of Liang & Zeger, 1986). rms^2 / matrix (2, 2) is the
 * effective number of points. f = 1.7 is measured: frames cut a surface out
 * differently, and errors as long as the plane are fitted. The normalized errors |z| of
 * planes matched over exact poses then have a median of 0.53 to 0.75 (0.67 for a normal
 * distribution).
 * \param[in] cloud the one the plane was found in, in the frame of the plane
 * \return nothing where the moments alone give none, or the inliers lie in fewer than
 * four blocks
 * \throw std::invalid_argument if an inlier lies outside the cloud */
PCL_OPS_EXPORT std::optional<PlaneCovariance>
planeCovariance (const CloudView& cloud, const PlaneSegment& plane);

/** \brief Names the orientation of planes anew, for another up axis.
 * \param[in,out] planes only their orientation changes
 * \param[in] up against gravity, any length but 0
 * \param[in] tolerance largest angle to be horizontal or vertical, 0 to pi/2 [rad]
 * \return false, with the planes as they were, where one of them is out of range */
PCL_OPS_EXPORT bool
nameOrientations (std::vector<PlaneSegment>& planes,
                  const Eigen::Vector3d& up,
                  double tolerance);

} // namespace pcl_ops
