// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <io/shifted_cloud.h>
#include <pcl_ops/plane.h>

namespace pcl_ops::apps {

/** \brief A pinhole camera that looks at a cloud. */
struct View {
  /** \brief Position of the camera, in the frame of the cloud. */
  Eigen::Vector3f eye = Eigen::Vector3f::Zero();
  /** \brief Its rows are unit vectors in the frame of the cloud: right and down in the
   * image, and the viewing direction. */
  Eigen::Matrix3f axes = Eigen::Matrix3f::Identity();
  /** \brief Focal length [pixel]. */
  float focal = 1.0f;
  /** \brief Column and row of the principal point, at which the camera looks [pixel].
   */
  Eigen::Vector2f center = Eigen::Vector2f::Zero();
  /** \brief Whether planes that are seen from behind are not drawn, so that the near
   * walls of a room do not hide its inside. */
  bool hides_backs = false;

  /** \brief Returns column and row [pixel], and depth [unit of the cloud], which is
   * positive in front of the camera. */
  Eigen::Vector3f
  project (const Eigen::Vector3f& point) const
  {
    const Eigen::Vector3f seen = axes * (point - eye);
    return Eigen::Vector3f (focal * seen.x() / seen.z() + center.x(),
                            focal * seen.y() / seen.z() + center.y(),
                            seen.z());
  }
};

/** \brief Returns a view that shows a cloud as its sensor saw it. If the points lie all
 * around the sensor, or too far away to have been seen from it, the view is from above
 * at a slant; from below, if only the view from above would hide most points on planes
 * (View::hides_backs). If no point is finite, returns a default \ref View.
 * \param[in] planes of the cloud, with normals that point to the sensor
 * \param[in] up direction against gravity
 * \param[in] width, height of the image [pixel], which the cloud will fill */
View
chooseView (const XyzCloud& cloud,
            const std::vector<PlaneSegment>& planes,
            const Eigen::Vector3f& up,
            int width,
            int height);

} // namespace pcl_ops::apps
