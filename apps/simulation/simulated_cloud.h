// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include "scene.h"

#include <vector>

namespace pcl_ops::simulation {

/** \brief A true plane of a simulated cloud, in its frame. */
struct LabeledPlane {
  std::uint32_t label = 0;
  Plane plane;
  std::size_t points = 0;
};

/** \brief Points with the label of the plane they were taken from: 1 .. P by falling
 * number of points, 0 for points on no plane. */
struct SimulatedCloud {
  pcl::PointCloud<pcl::PointXYZL> cloud;
  /** \brief Plane of label 1 first. */
  std::vector<LabeledPlane> planes;
};

/** \brief A surface with fewer points is too little to be seen as a plane: label 0. */
constexpr std::size_t min_points_of_plane = 50;

/** \brief Turns the surface identities that the cloud's labels hold into labels by
 * falling number of points.
 *
 * \param[in,out] cloud its labels are 0 or an index + 1 into \p surfaces; NaN points 0
 * \param[in] surfaces the plane of each surface
 * \return the planes that have \ref min_points_of_plane or more, label 1 first */
std::vector<LabeledPlane>
labelBySize (pcl::PointCloud<pcl::PointXYZL>& cloud,
             const std::vector<Plane>& surfaces);

inline pcl::PointXYZL
pointAt (const Eigen::Vector3d& position, SurfaceId surface)
{
  pcl::PointXYZL point;
  point.getVector3fMap() = position.cast<float>();
  point.label = surface;
  return point;
}

/** \brief What a sensor reads, ray by ray in the order it casts them. */
struct Scan {
  std::size_t columns = 0, rows = 0;
  /** \brief Whether the sensor casts the rays of a column one after the other, as a
   * rotating lidar does, and not those of a row. */
  bool column_by_column = false;
  /** \brief In the sensor's frame [m]; NaN: no reading. */
  std::vector<Eigen::Vector3d> points;
  std::vector<SurfaceId> surfaces;
};

enum class CloudLayout {
  /** \brief One point for each reading, in the order of the rays. */
  Readings,
  /** \brief One point for each ray, row by row, NaN without a reading. */
  Organized
};

/** \brief The points of a scan, each with the surface it was taken from.
 * \param[in] pose from the sensor's frame to that of the points; it becomes the cloud's
 * sensor origin and orientation */
pcl::PointCloud<pcl::PointXYZL>
toSurfaceCloud (const Scan& scan, const Eigen::Isometry3d& pose, CloudLayout layout);

/** \brief The same with the true planes of the scene.
 * \param[in] pose from the sensor's frame to that of the scene */
SimulatedCloud
toCloud (const Scan& scan,
         const Eigen::Isometry3d& pose,
         const Scene& scene,
         CloudLayout layout);

} // namespace pcl_ops::simulation
