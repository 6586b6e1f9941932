// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "picking.h"

#include <pcl/common/point_tests.h>

namespace pcl_ops::apps {

std::optional<pcl::index_t>
pointAt (const Eigen::Vector2d& pixel,
         double radius,
         const XyzCloud& cloud,
         const Projection& projection)
{
  std::optional<pcl::index_t> nearest;
  double least_depth = 1.0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (!pcl::isXYZFinite (cloud[i]))
      continue;
    const Eigen::Vector4d seen =
        projection.to_cube * cloud[i].getVector3fMap().cast<double>().homogeneous();
    if (!(seen.w() > 0.0))
      continue;
    const Eigen::Vector3d cube = seen.head<3>() / seen.w();
    const Eigen::Vector2d drawn =
        (0.5 * (cube.head<2>().array() + 1.0) * projection.size.array()).matrix();
    if (cube.z() < -1.0 || cube.z() >= least_depth || (drawn - pixel).norm() > radius)
      continue;
    least_depth = cube.z();
    nearest = static_cast<pcl::index_t> (i);
  }
  return nearest;
}

} // namespace pcl_ops::apps
