// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include "scene.h"

namespace pcl_ops::simulation {

using LabeledCloud = pcl::PointCloud<pcl::PointXYZL>;

/** Labels are 1 .. P by falling number of points, 0 for points on no plane. */
struct SimulatedCloud {
  LabeledCloud cloud;
  std::vector<Plane> planes; // that of label 1 first
  /** Of each point whether its truth is unknown, as on hilly ground: any answer is
   * right there. Empty: all are known. */
  std::vector<char> is_ignored = {};
  Vector3d up = Vector3d::UnitZ(); // against gravity, of length 1
};

/** Stands in for a surface where it is no plane, but parts of it may be called one. */
constexpr SurfaceId unknown_surface = std::numeric_limits<SurfaceId>::max();

/** A surface with fewer has label 0. */
constexpr std::size_t min_points_of_plane = 50;

/** \param[in] cloud its labels are surfaces; NaN points 0; points of \ref
 * unknown_surface are ignored and get label 0
 * \param[in] surfaces the plane of each
 * \param[in] min_points a surface with fewer has label 0 */
SimulatedCloud
labeledBySize (LabeledCloud cloud,
               const std::vector<Plane>& surfaces,
               std::size_t min_points = min_points_of_plane);

pcl::PointXYZL
pointAt (const Vector3d& position, SurfaceId surface);

/** Ray by ray, in the order a sensor casts them. */
struct Scan {
  std::size_t columns = 0, rows = 0;
  /** As a rotating lidar casts them. */
  bool column_by_column = false;
  /** In the sensor's frame [m]; NaN: no reading. */
  std::vector<Vector3d> points = {};
  std::vector<SurfaceId> surfaces = {};
};

/** Labeled by surfaces.
 * \param[in] pose from the sensor's frame to that of the points; becomes that of the
 * cloud
 * \param[in] organized one point for each ray, row by row, NaN without a reading; else
 * one for each reading, in the order of the rays */
LabeledCloud
toSurfaceCloud (const Scan& scan, const Isometry3d& pose, bool organized);

/** A point of a surface and the direction its distance errs in. */
struct SurfacePoint {
  Vector3d position, normal;
};

/** A uniform draw: of a cylinder from its side only. */
SurfacePoint
drawPoint (const Shape& shape, Random& random);

/** Spread by area, one shape after the other, labeled by surfaces.
 * \param[in] points exact number; none if the shapes have no area
 * \param[in] sigma standard deviation along the normal [m] */
LabeledCloud
drawPoints (const Shapes& shapes, std::size_t points, double sigma, Random& random);

/** Standard deviation of a terrestrial laser scanner's distances [m]. */
constexpr double laser_sigma = 0.003;

/** All surfaces evenly, whatever hides them: a registered scan from everywhere. The
 * sensor's origin is the middle of the first body, the room's shell. */
SimulatedCloud
scanDensely (const Scene& scene, std::size_t points, double noise, Seed seed);

} // namespace pcl_ops::simulation
