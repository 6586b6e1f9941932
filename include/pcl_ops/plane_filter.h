// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <pcl_ops/cloud_view.h>
#include <pcl_ops/export.h>
#include <pcl_ops/orientation.h>
#include <pcl_ops/plane.h>
#include <pcl_ops/plane_extent.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pcl_ops {

/** \brief Which planes to keep; by default all. */
struct PlaneFilter {
  std::optional<Orientation> orientation;
  /** \brief Planes whose normals are parallel to it, of either sign, are kept: a vector
   * of any length but 0, in the frame of the planes. */
  std::optional<Eigen::Vector3d> direction;
  /** \brief Largest angle between a normal and \ref direction [rad]; default 10
   * degrees. */
  double direction_tolerance = 10.0 * (M_PI / 180.0);
  /** \brief Smallest and largest angle between the plane and the horizontal [rad], of
   * 0 to pi/2. Not given: any. */
  std::optional<std::array<double, 2>> slope;
  /** \brief For \ref slope, against gravity, in the frame of the planes; of any length
   * but 0. */
  Eigen::Vector3d up_axis = Eigen::Vector3d::UnitZ();
  /** \brief How many points a plane needs: inliers, or points of the moments where
   * there are no inliers. */
  std::size_t min_points = 0;
  /** \brief Smallest area inside the outline [m^2]. */
  double min_area = 0.0;
  /** \brief Smallest width of the rectangle around the outline [m]. */
  double min_width = 0.0;
  /** \brief Largest area inside the outline [m^2]. Not given: any. */
  std::optional<double> max_area;
  /** \brief Largest width of the rectangle around the outline [m]. Not given: any. */
  std::optional<double> max_width;
  /** \brief {side, side, tolerance} of the rectangle around the outline [m], the sides
   * in any order: a board of known size. Not given: any. */
  std::optional<std::array<double, 3>> size;
  /** \brief Of the planes that are left, the first so many are kept. */
  std::optional<std::size_t> max_planes;
};

/** \brief What is wrong with a filter, as a sentence; empty if nothing is. */
PCL_OPS_EXPORT std::string
validate (const PlaneFilter& filter);

/** \brief How many planes a filter dropped. The tests run in this order, and a plane is
 * counted at the first one it fails. */
struct DroppedPlanes {
  std::size_t by_orientation = 0;
  std::size_t by_direction = 0;
  std::size_t by_slope = 0;
  std::size_t by_points = 0;
  std::size_t by_area = 0;
  std::size_t by_width = 0;
  std::size_t by_max_area = 0;
  std::size_t by_max_width = 0;
  std::size_t by_size = 0;
  std::size_t by_number = 0;

  std::size_t
  total () const
  {
    return by_orientation + by_direction + by_slope + by_points + by_area + by_width +
           by_max_area + by_max_width + by_size + by_number;
  }
};

/** \brief Where a plane ends. */
using ExtentOfPlane = std::function<PlaneExtent (const PlaneSegment&)>;

/** \brief The positions of the planes that a filter keeps, in their order.
 * \param[in] planes in any frame
 * \param[in] filter one \ref validate finds nothing wrong with
 * \param[in] extent_of asked, with elements of \p planes, only for planes whose area or
 * width decides
 * \param[out] dropped how many are dropped, and why
 * \throw std::invalid_argument if there is a problem */
PCL_OPS_EXPORT std::vector<std::size_t>
keptPlanes (const std::vector<PlaneSegment>& planes,
            const PlaneFilter& filter,
            const ExtentOfPlane& extent_of,
            DroppedPlanes& dropped);

/** \brief Drops the planes that a filter does not keep, as \ref keptPlanes says.
 * \return how many were dropped, and why */
PCL_OPS_EXPORT DroppedPlanes
filterPlanes (std::vector<PlaneSegment>& planes,
              const PlaneFilter& filter,
              const ExtentOfPlane& extent_of);

/** \brief The same with the extents of \ref planeExtent in the input cloud.
 * \throw std::invalid_argument if one asked for has an inlier outside the cloud, too */
PCL_OPS_EXPORT DroppedPlanes
filterPlanes (std::vector<PlaneSegment>& planes,
              const PlaneFilter& filter,
              const CloudView& cloud);

} // namespace pcl_ops
