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

/** \brief Conditions for planes to keep. By default all planes are kept. */
struct PlaneFilter {
  /** \brief Orientation of the planes to keep. Not given: any. */
  std::optional<Orientation> orientation;
  /** \brief Planes whose normals, of either sign, are parallel to this vector are kept.
   * The vector has any length but 0, in the frame of the planes. Not given: any. */
  std::optional<Eigen::Vector3d> direction;
  /** \brief Largest angle between a normal and \ref direction [rad]; default 10
   * degrees. */
  double direction_tolerance = 10.0 * (M_PI / 180.0);
  /** \brief Smallest and largest angle between the plane and the horizontal, both 0 to
   * pi/2 [rad]. Not given: any. */
  std::optional<std::array<double, 2>> slope;
  /** \brief Direction against gravity for \ref slope, in the frame of the planes, of
   * any length but 0. */
  Eigen::Vector3d up_axis = Eigen::Vector3d::UnitZ();
  /** \brief Smallest number of points of a plane: its inliers, or the count of its
   * moments if it has no inliers. */
  std::size_t min_points = 0;
  /** \brief Smallest area, PlaneExtent::area [m^2]: without holes. */
  double min_area = 0.0;
  /** \brief Smallest width of the rectangle around the outline [m]. */
  double min_width = 0.0;
  /** \brief Largest area, without holes, too [m^2]. Not given: any. */
  std::optional<double> max_area;
  /** \brief Largest width of the rectangle around the outline [m]. Not given: any. */
  std::optional<double> max_width;
  /** \brief {side, side, tolerance} of the rectangle around the outline [m], with the
   * sides in any order: finds a board of known size. Not given: any. */
  std::optional<std::array<double, 3>> size;
  /** \brief Largest number of planes: of planes that pass all tests, the first ones in
   * the list are kept. Not given: no limit. */
  std::optional<std::size_t> max_planes;
};

/** \brief Returns the first problem of a filter; empty if it is valid. */
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

/** \brief A function that returns the extent of a plane. */
using ExtentOfPlane = std::function<PlaneExtent (const PlaneSegment&)>;

/** \brief Returns the indices of the planes that a filter keeps, ascending.
 * \param[in] planes in any frame
 * \param[in] filter must be valid (\ref validate)
 * \param[in] extent_of is called with elements of \p planes, only for planes that pass
 * the other tests and only if the filter tests areas, widths or sizes
 * \param[out] dropped number of dropped planes for each test
 * \throw std::invalid_argument if the filter is not valid */
PCL_OPS_EXPORT std::vector<std::size_t>
keptPlanes (const std::vector<PlaneSegment>& planes,
            const PlaneFilter& filter,
            const ExtentOfPlane& extent_of,
            DroppedPlanes& dropped);

/** \brief Removes the planes that a filter does not keep (\ref keptPlanes).
 * \return number of dropped planes for each test */
PCL_OPS_EXPORT DroppedPlanes
filterPlanes (std::vector<PlaneSegment>& planes,
              const PlaneFilter& filter,
              const ExtentOfPlane& extent_of);

/** \brief The same with the extents of \ref planeExtent in the input cloud.
 * \throw std::invalid_argument if the filter is not valid, or if an inlier of a plane
 * whose extent is needed is not an index into the cloud */
PCL_OPS_EXPORT DroppedPlanes
filterPlanes (std::vector<PlaneSegment>& planes,
              const PlaneFilter& filter,
              const CloudView& cloud);

} // namespace pcl_ops
