// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <pcl_ops/cloud_view.h>
#include <pcl_ops/export.h>
#include <pcl_ops/plane.h>

#include <vector>

namespace pcl_ops {

/** \brief A right-handed frame with two axes u and v in a plane and its normal as the
 * third axis. */
class PCL_OPS_EXPORT PlaneFrame {
public:
  /** \param[in] origin zero of the frame: a point on the plane near the points, so that
   * coordinates stay exact even if the cloud is far from its own zero
   * \param[in] normal unit normal of the plane */
  PlaneFrame (const Eigen::Vector3d& origin, const Eigen::Vector3d& normal);

  /** \brief Returns the coordinates u and v of a point projected onto the plane [m]. */
  Eigen::Vector2d
  toPlane (const Eigen::Vector3d& point) const
  {
    return axes_.transpose() * (point - origin_);
  }
  /** \brief Returns the point of the plane with the coordinates u and v. */
  Eigen::Vector3d
  toSpace (const Eigen::Vector2d& point) const
  {
    return origin_ + axes_ * point;
  }
  /** \brief The same as \ref toSpace for a direction: without the origin. */
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

/** \brief A polygon with holes: first its outer ring, counter-clockwise, then the rings
 * of its holes, clockwise. No ring repeats its first corner. Empty: no polygon. */
using PlanarRings = std::vector<PlanarPoints>;

/** \brief Outline, area and bounding rectangle of a plane, in the frame of the plane's
 * cloud. */
struct PlaneExtent {
  /** \brief Corners of the outline, on the plane, counter-clockwise seen from the side
   * the normal points to. The first corner is not repeated. Empty if the points span no
   * area: fewer than three points, or points that are equal or on one line. */
  std::vector<Eigen::Vector3d> hull;
  /** \brief Outlines of holes, clockwise. A convex hull has no holes. */
  std::vector<std::vector<Eigen::Vector3d>> holes;
  /** \brief Area inside the outline minus the area of the holes [m^2]. */
  double area = 0.0;
  /** \brief Center of the minimum-area bounding rectangle of the outline. */
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  /** \brief Unit vector along the longer sides of the rectangle. */
  Eigen::Vector3d long_axis = Eigen::Vector3d::UnitX();
  /** \brief Unit vector along the shorter sides: long_axis x short_axis = normal. */
  Eigen::Vector3d short_axis = Eigen::Vector3d::UnitY();
  /** \brief Length of the longer sides of the rectangle [m]; 0 for equal points. */
  double length = 0.0;
  /** \brief Length of the shorter sides of the rectangle [m]; 0 for points on one line.
   */
  double width = 0.0;

  /** \brief Returns \ref hull, then the \ref holes. */
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

/** \brief Returns the convex hull of points in a plane without the outliers that noise
 * scatters beyond the edge.
 *
 * The corners of the hull of all points are the few points with the largest errors. So
 * the outermost points are removed layer by layer, while the density of a layer is less
 * than half of the mean density inside. Noise blurs the edge of a surface, and at the
 * true edge the density has fallen to one half. At a sharp edge no points are removed.
 * \param[in] points in any order; points with a NaN or infinite coordinate are left out
 * \param[in] max_outside largest share of the points that may be outside, 0 to 1; the
 * hull of all points for 0 or less, and for NaN
 * \return corners counter-clockwise, the first not repeated; empty if the points span
 * no area */
PCL_OPS_EXPORT PlanarPoints
convexHull (const PlanarPoints& points, double max_outside = 0.01);

/** \brief Returns the extent of an outline, convex or not: area and bounding rectangle.
 * \param[in] rings the outline and its holes, in the coordinates of \p frame [m]
 * \param[in] points in the same coordinates, on one line: if the outline is empty, the
 * rectangle is that of these points
 * \param[in] frame the frame in the plane of the rings
 * \return the extent in the frame of the cloud */
PCL_OPS_EXPORT PlaneExtent
extentOf (const PlanarRings& rings,
          const PlanarPoints& points,
          const PlaneFrame& frame);

/** \brief Returns the inliers of a plane, projected onto the plane of \p frame, in its
 * coordinates [m]. Cloud, plane and \p frame must be in the same coordinate system.
 * \throw std::invalid_argument if an inlier is not an index into the cloud */
PCL_OPS_EXPORT PlanarPoints
pointsOnPlane (const CloudView& cloud,
               const PlaneSegment& plane,
               const PlaneFrame& frame);

/** \brief Returns the extent of a plane, with the convex hull of its inliers as
 * outline: at least 99 % of the inliers lie inside (\ref convexHull).
 * \param[in] cloud the input cloud of the detection
 * \param[in] plane in the frame of the cloud
 * \throw std::invalid_argument if an inlier is not an index into the cloud */
PCL_OPS_EXPORT PlaneExtent
planeExtent (const CloudView& cloud, const PlaneSegment& plane);

} // namespace pcl_ops
