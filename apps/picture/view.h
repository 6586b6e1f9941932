// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <io/shifted_cloud.h>
#include <pcl_ops/plane.h>

namespace pcl_ops::apps {

/** \brief A pinhole camera that looks at a cloud. */
struct View {
  /** \brief Position of the camera. */
  Eigen::Vector3f eye = Eigen::Vector3f::Zero();
  /** \brief Rows: the image's right and down and the viewing direction. */
  Eigen::Matrix3f axes = Eigen::Matrix3f::Identity();
  /** \brief Focal length [pixel]. */
  float focal = 1.0f;
  /** \brief Principal point, column and row [pixel]. */
  Eigen::Vector2f center = Eigen::Vector2f::Zero();
  /** \brief Whether planes seen from behind are left out, as are the near walls when a
   * room is seen from outside. */
  bool hides_backs = false;

  /** \return column and row, and depth, which is positive in front of the camera */
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
 * at a slant. If that hides most points on planes (View::hides_backs), and a view from
 * below does not, it is from below. If no point is finite, it is a default \ref View.
 * \param[in] planes whose normals point to the sensor
 * \param[in] up direction against gravity
 * \param[in] width, height of the image [pixel], which the cloud will fill */
View
chooseView (const XyzCloud& cloud,
            const std::vector<PlaneSegment>& planes,
            const Eigen::Vector3f& up,
            int width,
            int height);

} // namespace pcl_ops::apps
