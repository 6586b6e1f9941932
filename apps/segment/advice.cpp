// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "advice.h"

#include <pcl/common/point_tests.h>

#include <Eigen/Geometry>

#include <cmath>
#include <sstream>
#include <string>

namespace pcl_ops::apps {

std::string
adviceForOps (const OrientedPointSamplingParameters& parameters,
              const pcl::PointCloud<pcl::PointXYZ>& cloud)
{
  // A room of 10 m in millimetres; no scene in metres is that large for 5 cm.
  constexpr double kLargestExtentInThresholds = 40000.0;
  std::size_t finite = 0;
  Eigen::AlignedBox3f box;
  for (const pcl::PointXYZ& point : cloud) {
    if (!pcl::isXYZFinite (point))
      continue;
    ++finite;
    box.extend (point.getVector3fMap());
  }
  const double samples =
      std::floor (parameters.sampling_rate * static_cast<double> (finite));
  const double extent = finite == 0 ? 0.0 : box.diagonal().norm();
  const bool on_cells = parameters.sampling == Sampling::Cells;
  // On cells the noise sets the distance unless the user does.
  const double threshold = parameters.distance_threshold;

  std::ostringstream advice;
  if (finite == 0)
    advice << "every point is NaN or infinite";
  else if (!on_cells && samples <= parameters.min_inliers)
    advice << "only " << samples << " of " << finite
           << " points were sampled and a plane needs more than --min-inliers "
           << parameters.min_inliers << ": raise --sampling-rate ("
           << parameters.sampling_rate << ") or lower --min-inliers";
  else if (threshold > 0.0 && extent > kLargestExtentInThresholds * threshold)
    advice << "the cloud is " << extent << " wide: if its unit is the millimetre, give "
           << "--threshold in millimetres, too (now " << threshold << ")";
  else
    advice << "lower --min-inliers (" << parameters.min_inliers
           << ") or raise --sampling-rate (" << parameters.sampling_rate
           << ") if the planes are small, raise --threshold ("
           << (threshold > 0.0 ? std::to_string (threshold) : "auto")
           << ") if the points are noisy";
  return advice.str();
}

} // namespace pcl_ops::apps
