// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <pcl_ops/cloud_view.h>
#include <pcl_ops/export.h>
#include <pcl_ops/plane.h>

#include <vector>

namespace pcl_ops {

/** \brief A right-handed frame in a plane: u, v, and the normal as the third axis. */
class PCL_OPS_EXPORT PlaneFrame {
public:
  /** \param[in] origin zero of the frame, on the plane and near the points: that keeps
   * doubles exact however far the cloud is from its own zero
   * \param[in] normal unit normal of the plane */
  PlaneFrame (const Eigen::Vector3d& origin, const Eigen::Vector3d& normal);

  /** \brief Where a point lies once it is projected onto the plane. */
  Eigen::Vector2d
  toPlane (const Eigen::Vector3d& point) const
  {
    return axes_.transpose() * (point - origin_);
  }
  Eigen::Vector3d
  toSpace (const Eigen::Vector2d& point) const
  {
    return origin_ + axes_ * point;
  }
  /** \brief As \ref toSpace, for a direction. */
  Eigen::Vector3d
  directionInSpace (const Eigen::Vector2d& direction) const
  {
    return axes_ * direction;
  }

private:
  Eigen::Vector3d origin_;
  Eigen::Matrix<double, 3, 2> axes_;
};

/** \brief Points or a polygon in a plane, in the coordinates of a PlaneFrame [m]. */
using PlanarPoints = std::vector<Eigen::Vector2d>;

/** \brief An outline with holes: the ring around it, counter-clockwise, then those
 * around its holes, clockwise; no ring repeats its first corner. Empty where there is
 * no outline. */
using PlanarRings = std::vector<PlanarPoints>;

/** \brief Where a plane ends, in the frame of the input cloud. */
struct PlaneExtent {
  /** \brief Corners of the outline, on the plane, counter-clockwise seen from the side
   * the normal points to, the first not repeated. Empty where the points span no area:
   * fewer than three, all on one line, or all equal. */
  std::vector<Eigen::Vector3d> hull;
  /** \brief Outlines of holes inside of it, clockwise; of a convex outline none. */
  std::vector<std::vector<Eigen::Vector3d>> holes;
  /** \brief Area inside the outline, less the holes [m^2]. */
  double area = 0.0;
  /** \brief The smallest rectangle around the outline: its center, its sides as unit
   * vectors with long_axis x short_axis = normal, and how long they are [m]. Of points
   * on one line the width is 0, of equal points the length, too. */
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  Eigen::Vector3d long_axis = Eigen::Vector3d::UnitX();
  Eigen::Vector3d short_axis = Eigen::Vector3d::UnitY();
  double length = 0.0;
  double width = 0.0;

  /** \brief \ref hull, then the \ref holes; nothing where there is no hull. */
  std::vector<std::vector<Eigen::Vector3d>>
  rings () const
  {
    std::vector<std::vector<Eigen::Vector3d>> all;
    if (!hull.empty())
      all.push_back (hull);
    all.insert (all.end(), holes.begin(), holes.end());
    return all;
  }
};

/** \brief The convex outline of points in a plane, without the fringe that noise gives
 * its rim.
 *
 * A raw hull hangs on the few points that noise carried farthest. So its corners are
 * taken off, layer by layer, while points there are less than half as dense as within:
 * the edge of a surface, blurred by noise, is where the density has fallen to one half.
 * Sharp edges keep every point.
 * \param[in] points in any order; those with a NaN or infinite coordinate are left out
 * \param[in] max_outside largest share of the points that is left outside, 0 to 1; 0:
 * none
 * \return counter-clockwise, the first corner not repeated; empty where the points span
 * no area */
PCL_OPS_EXPORT PlanarPoints
convexHull (const PlanarPoints& points, double max_outside = 0.01);

/** \brief Area and smallest rectangle of an outline, convex or not.
 * \param[in] rings in the coordinates of the frame [m]
 * \param[in] points what the rectangle is put around where there is no outline
 * \param[in] frame the plane of the rings
 * \return in the frame of the cloud, with the area less that of the holes [m^2] */
PCL_OPS_EXPORT PlaneExtent
extentOf (const PlanarRings& rings,
          const PlanarPoints& points,
          const PlaneFrame& frame);

/** \brief The inliers of a plane in a cloud, projected onto a frame; cloud, plane and
 * frame are in one frame of coordinates.
 * \throw std::invalid_argument if an inlier lies outside the cloud */
PCL_OPS_EXPORT PlanarPoints
pointsOnPlane (const CloudView& cloud,
               const PlaneSegment& plane,
               const PlaneFrame& frame);

/** \brief Extent, area and convex hull of a plane in its input cloud; at least 99 % of
 * its inliers lie inside (\ref convexHull). The plane is as it was found: not moved.
 * \throw std::invalid_argument if an inlier lies outside the cloud */
PCL_OPS_EXPORT PlaneExtent
planeExtent (const CloudView& cloud, const PlaneSegment& plane);

} // namespace pcl_ops
