// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/cloud_view.h>
#include <pcl_ops/fast_sampling_plane_filtering.h>
#include <pcl_ops/kernel_hough_transform.h>
#include <pcl_ops/oriented_point_sampling.h>
#include <pcl_ops/plane.h>

#include <vector>

namespace pcl_ops {

/** \brief Finds planes as \ref detectPlanes does.
 * \return the planes, the times of the stages, the number of planes before merging, and
 * the voxel size and distance threshold that were used */
template <typename Parameters>
detail::Detection
detectPlanesInDetail (const CloudView& cloud,
                      const Parameters& parameters,
                      const Eigen::Vector3d& viewpoint = Eigen::Vector3d::Zero())
{
  return detail::detectChecked ({cloud, nullptr, viewpoint, nullptr}, parameters);
}

/** \brief Finds planes in any buffer of positions, without a pcl::PointCloud. The type
 * of the parameters chooses the detector.
 * \param[in] cloud may have points with NaN or infinite coordinates, which are skipped
 * \param[in] parameters must be valid (\ref validate)
 * \param[in] viewpoint origin of the sensor in the frame of the cloud [m]. Normals
 * point to it; \ref PlaneSegment::normal has the exception for 0 0 0
 * \return planes by descending number of inliers
 * \throw std::invalid_argument if the cloud is empty or the parameters are wrong */
template <typename Parameters>
std::vector<PlaneSegment>
detectPlanes (const CloudView& cloud,
              const Parameters& parameters,
              const Eigen::Vector3d& viewpoint = Eigen::Vector3d::Zero())
{
  return detectPlanesInDetail (cloud, parameters, viewpoint).planes;
}

} // namespace pcl_ops
