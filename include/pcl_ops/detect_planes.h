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

/** \brief As \ref detectPlanes.
 * \return the planes with the times of the stages and the lengths that were used, as the
 * classes of the detectors tell them */
template <typename Parameters>
detail::Detection
detectPlanesInDetail (const CloudView& cloud,
                      const Parameters& parameters,
                      const Eigen::Vector3d& viewpoint = Eigen::Vector3d::Zero())
{
  return detail::detectChecked ({cloud, nullptr, viewpoint, nullptr}, parameters);
}

/** \brief Finds planes in any buffer of positions, without a pcl::PointCloud; the type
 * of the parameters chooses the detector.
 * \param[in] cloud finite points or not
 * \param[in] parameters ones \ref validate finds nothing wrong with
 * \param[in] viewpoint origin of the sensor in the frame of the cloud [m]; normals
 * point to it; where it is 0 0 0, as \ref PlaneSegment::normal says
 * \return planes by falling size
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
