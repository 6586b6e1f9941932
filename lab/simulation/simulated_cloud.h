// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include "scene.h"

namespace pcl_ops::simulation {

using LabeledCloud = pcl::PointCloud<pcl::PointXYZL>;

/** A cloud with true labels: 1 .. P by falling number of points, 0 is no plane. */
struct SimulatedCloud {
  LabeledCloud cloud;
  std::vector<Plane> planes; // the plane of label i at index i - 1
  /** For each point, whether its truth is unknown, as on hilly ground: any label is
   * right there. Empty: all truth is known. */
  std::vector<char> is_ignored = {};
  Vector3d up = Vector3d::UnitZ(); // against gravity, of length 1
};

/** The \ref SurfaceId of surfaces that are no planes, but have parts that a detector
 * may rightly call planes: their truth is unknown. */
constexpr SurfaceId unknown_surface = std::numeric_limits<SurfaceId>::max();

/** Default of \ref labeledBySize: points of a surface with fewer points get label 0, as
 * in the paper (section IV-A). */
constexpr std::size_t min_points_of_plane = 50;

/** Replaces surface numbers by labels, in the order of falling number of points.
 * \param[in] cloud its labels are surface numbers, 0 for NaN points; points of \ref
 * unknown_surface are ignored and get label 0
 * \param[in] surfaces the plane of surface i at index i - 1
 * \param[in] min_points points of a surface with fewer points get label 0 */
SimulatedCloud
labeledBySize (LabeledCloud cloud,
               const std::vector<Plane>& surfaces,
               std::size_t min_points = min_points_of_plane);

/** \param[in] surface becomes the label */
pcl::PointXYZL
pointAt (const Vector3d& position, SurfaceId surface);

/** One reading per ray, in the order in which a sensor casts the rays. */
struct Scan {
  std::size_t columns = 0, rows = 0;
  /** Whether rays are cast column by column, as by a rotating lidar; false: row by row.
   */
  bool column_by_column = false;
  /** In the sensor's frame [m]; NaN: no reading. */
  std::vector<Vector3d> points = {};
  std::vector<SurfaceId> surfaces = {}; // of each point
};

/** Returns a cloud whose labels are surface numbers.
 * \param[in] pose from the sensor's frame to the frame of the points; becomes the
 * sensor pose of the cloud
 * \param[in] organized true: one point per ray, row by row, NaN without a reading;
 * false: one point per reading, in the order of the rays */
LabeledCloud
toSurfaceCloud (const Scan& scan, const Isometry3d& pose, bool organized);

/** A point on a surface, and the surface normal, along which noise shifts it. */
struct SurfacePoint {
  Vector3d position, normal;
};

/** Draws a point uniformly by area; of a cylinder only on its curved side. */
SurfacePoint
drawPoint (const Shape& shape, Random& random);

/** Draws points uniformly by area, one shape after the other; labels are surface
 * numbers.
 * \param[in] points exact number; the cloud is empty if the shapes have no area
 * \param[in] sigma standard deviation of the points along the normal [m] */
LabeledCloud
drawPoints (const Shapes& shapes, std::size_t points, double sigma, Random& random);

/** Standard deviation of a terrestrial laser scanner's distances [m]. */
constexpr double laser_sigma = 0.003;

/** Scans all rectangles, spheres and cylinders with equal density, also hidden ones, as
 * if scans from everywhere were joined. The sensor's origin is the middle of the first
 * body, which is the shell of a room.
 * \param[in] points number of points
 * \param[in] noise factor on \ref laser_sigma */
SimulatedCloud
scanDensely (const Scene& scene, std::size_t points, double noise, Seed seed);

} // namespace pcl_ops::simulation
