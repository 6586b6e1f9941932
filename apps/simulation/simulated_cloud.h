// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include "scene.h"

#include <vector>

namespace pcl_ops::simulation {

using LabeledCloud = pcl::PointCloud<pcl::PointXYZL>;

/** \brief Points with the label of the plane they were taken from: 1 .. P by falling
 * number of points, 0 for points on no plane. */
struct SimulatedCloud {
  LabeledCloud cloud;
  /** \brief Plane of label 1 first. */
  std::vector<Plane> planes;
};

/** \brief A surface with fewer points is too little to be seen as a plane: label 0. */
constexpr std::size_t min_points_of_plane = 50;

/** \brief Turns surfaces into labels by falling number of points.
 * \param[in] cloud its labels are 0 or an index + 1 into \p surfaces; NaN points 0
 * \param[in] surfaces the plane of each surface */
SimulatedCloud
labeledBySize (LabeledCloud cloud, const std::vector<Plane>& surfaces);

pcl::PointXYZL
pointAt (const Vector3d& position, SurfaceId surface);

/** \brief What a sensor reads, ray by ray in the order it casts them. */
struct Scan {
  std::size_t columns = 0, rows = 0;
  /** \brief Whether the rays of a column follow one another, as those of a rotating
   * lidar, and not those of a row. */
  bool column_by_column = false;
  /** \brief In the sensor's frame [m]; NaN: no reading. */
  std::vector<Vector3d> points = {};
  std::vector<SurfaceId> surfaces = {};
};

/** \brief The points of a scan, each with its surface.
 * \param[in] pose from the sensor's frame to that of the points; it becomes the cloud's
 * sensor origin and orientation
 * \param[in] organized one point for each ray, row by row, NaN without a reading; else
 * one for each reading, in the order of the rays */
LabeledCloud
toSurfaceCloud (const Scan& scan, const Isometry3d& pose, bool organized);

/** \brief A point of a surface and the direction its distance errs in. */
struct SurfacePoint {
  Vector3d position, normal;
};

/** \brief A uniform draw: of a cylinder from its side only. */
SurfacePoint
drawPoint (const Shape& shape, Random& random);

/** \brief Points spread over shapes by area, one shape after the other, with its
 * surface as label.
 * \param[in] points exact number of points; none if the shapes have no area
 * \param[in] sigma standard deviation along the normal [m] */
LabeledCloud
drawPoints (const std::vector<Shape>& shapes,
            std::size_t points,
            double sigma,
            Random& random);

/** \brief Standard deviation of a terrestrial laser scanner's distances [m]. */
constexpr double laser_sigma = 0.003;

/** \brief Scans all surfaces of a scene evenly, whatever hides them: a registered scan
 * from everywhere. The sensor's origin is the middle of the first body, the room's
 * shell. */
SimulatedCloud
scanDensely (const Scene& scene, std::size_t points, double noise, Seed seed);

} // namespace pcl_ops::simulation
