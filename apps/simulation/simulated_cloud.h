// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include "depth_camera.h"
#include "lidar.h"

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
constexpr std::size_t fewest_points_of_plane = 50;

enum class CloudLayout {
  /** \brief One point for each reading. */
  Readings,
  /** \brief One point for each pixel or, in rows of beams, for each ray, NaN without a
   * reading. */
  Organized
};

/** \brief The points of a depth image, each with the surface it was taken from.
 * \param[in] camera its pose, which becomes the sensor's, is from its frame to that of
 * the points */
pcl::PointCloud<pcl::PointXYZL>
toSurfaceCloud (const DepthImage& image, const DepthCamera& camera, CloudLayout layout);

/** \brief The points of a depth image in the frame of the room, with the camera's pose
 * as sensor origin and orientation. */
SimulatedCloud
toCloud (const DepthImage& image,
         const DepthCamera& camera,
         const Scene& scene,
         CloudLayout layout);

/** \brief The points of a scan, each with the surface it was taken from.
 * \param[in] pose from the lidar's frame to that of the points; it becomes the sensor's
 */
pcl::PointCloud<pcl::PointXYZL>
toSurfaceCloud (const LidarScan& scan,
                const Eigen::Isometry3d& pose,
                CloudLayout layout);

/** \brief The points of a scan in the frame of the scene, with the lidar's pose as
 * sensor origin and orientation. */
SimulatedCloud
toCloud (const LidarScan& scan,
         const Lidar& lidar,
         const Scene& scene,
         CloudLayout layout);

/** \brief Turns the surface identities that the cloud's labels hold into labels by
 * falling number of points.
 *
 * \param[in,out] cloud its labels are 0 or an index + 1 into \p surfaces; NaN points 0
 * \param[in] surfaces the plane of each surface
 * \return the planes that have \ref fewest_points_of_plane or more, label 1 first */
std::vector<LabeledPlane>
labelBySize (pcl::PointCloud<pcl::PointXYZL>& cloud,
             const std::vector<Plane>& surfaces);

} // namespace pcl_ops::simulation
