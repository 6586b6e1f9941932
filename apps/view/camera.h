// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <io/xyz_cloud.h>
#include <pcl_ops/plane.h>

#include <vector>

namespace pcl_ops::apps {

/** \brief A camera as VTK has it: it looks at a point and turns around it. */
struct Camera {
  Eigen::Vector3d eye = -Eigen::Vector3d::UnitZ();
  Eigen::Vector3d target = Eigen::Vector3d::Zero();
  Eigen::Vector3d up = Eigen::Vector3d::UnitY();
  /** \brief From the lower to the upper edge of the window [degree]. */
  double angle = 30.0;
};

/** \brief Shows the whole cloud from where its pictures do (\ref chooseView).
 * \param[in] cloud with the sensor's pose, and at least one finite point
 * \param[in] planes whose normals point to the sensor
 * \param[in] gravity_up direction against gravity
 * \param[in] width, height of the window [pixel] */
Camera
cameraFor (const XyzCloud& cloud,
           const std::vector<PlaneSegment>& planes,
           const Eigen::Vector3f& gravity_up,
           int width,
           int height);

/** \brief Size of points just large enough to close the gaps between them [pixel].
 * \param[in] points how many are seen
 * \param[in] width, height of the window [pixel] */
int
pointSizeFor (std::size_t points, int width, int height);

} // namespace pcl_ops::apps
