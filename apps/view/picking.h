// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/types.h>

#include <Eigen/Core>

#include <io/xyz_cloud.h>

#include <optional>

namespace pcl_ops::apps {

/** \brief How points come to a window. */
struct Projection {
  /** \brief From the frame of the cloud to a cube: x, y and z from -1 to 1 once divided
   * by the fourth; x to the right, y up, z away from the eye. */
  Eigen::Matrix4d to_cube = Eigen::Matrix4d::Identity();
  /** \brief Size of the window [pixel]. */
  Eigen::Vector2d size = Eigen::Vector2d::Ones();
};

/** \brief The point that is seen at a pixel: of those that are drawn over it the one
 * nearest to the eye.
 * \param[in] pixel from the lower left corner of the window
 * \param[in] radius how far from its centre a point is drawn [pixel]
 * \return nothing if there is none */
std::optional<pcl::index_t>
pointAt (const Eigen::Vector2d& pixel,
         double radius,
         const XyzCloud& cloud,
         const Projection& projection);

} // namespace pcl_ops::apps
