// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/orientation.h>

#include <pcl/memory.h>
#include <pcl/types.h>

#include <Eigen/Core>

#include <array>
#include <optional>
#include <vector>

namespace pcl_ops {

/** \brief Count, sum and sum of outer products of a set of points: all that a least
 * squares plane needs, additive, so that joining two sets costs O(1).
 *
 * The sums are in double and taken about \ref origin, which should lie near the points:
 * that keeps them exact enough for clouds 10^6 m from the frame's zero. */
struct Moments {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero ();
  double count = 0.0;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero ();
  /** \brief xx xy xz yy yz zz */
  std::array<double, 6> products{};

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
    for (std::size_t i = 0; i < products.size (); ++i)
      products[i] += other.products[i];
  }

  /** \brief Adds another set; its sums are shifted if its origin differs. */
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
  covariance () const;
};

/** \brief The plane normal . x + offset = 0 with a unit normal. */
struct Plane {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ ();
  double offset = 0.0;

  /** \brief Signed distance of a point [m]. */
  double
  distance (const Eigen::Vector3d& point) const
  {
    return normal.dot (point) + offset;
  }
};

/** \brief Mean squared distance of a set of points to a plane in the frame of the
 * moments' origin [m^2]; undefined for count 0. */
double
meanSquaredDistance (const Moments& moments, const Plane& plane);

/** \brief A least squares plane with what its fit says about the points. */
struct PlaneFit {
  Plane plane;
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero ();
  /** \brief Variances along the principal axes, ascending [m^2]. The first is the squared
   * rms distance of the points to the plane. */
  Eigen::Vector3d variances = Eigen::Vector3d::Zero ();
};

/** \brief The plane with the smallest sum of squared distances (centred, in double).
 * \return nothing for fewer than three points or if they are on one line or all equal */
std::optional<PlaneFit>
fitPlane (const Moments& moments);

/** \brief The plane through \p point with unit normal \p normal. */
inline Plane
planeThrough (const Eigen::Vector3d& point, const Eigen::Vector3d& normal)
{
  return Plane{normal, -normal.dot (point)};
}

/** \brief A detected plane with the points on it, in the frame of the input cloud. */
struct PlaneSegment {
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero ();
  /** \brief Unit normal towards the sensor's origin. */
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ ();
  Orientation orientation = Orientation::Other;
  /** \brief Moments of the inliers about \ref centroid. */
  Moments moments;
  /** \brief Ascending indices into the input cloud. */
  pcl::Indices inliers;

  /** \brief The plane equation's normal and offset in the frame of the input cloud. */
  Plane
  plane () const
  {
    return planeThrough (centroid, normal);
  }

  /** \brief Root mean square distance of the inliers to the plane [m]. */
  double
  rms () const;
};

} // namespace pcl_ops
