// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "peers.h"
#include <open3d/geometry/PointCloud.h>
#include <open3d/utility/Random.h>
#ifdef _OPENMP
#include <omp.h>
#endif

namespace pcl_ops::evaluation {

Planes
planesByOpen3d (const PeerTask& task)
{
  constexpr int points_of_sample = 3;
  constexpr int iterations = 1000; // as in planesByPclRansac
#ifdef _OPENMP
  omp_set_num_threads (1); // other peers have one thread, too
#endif
  open3d::utility::random::Seed (int (task.settings.seed));
  return peelPlanes (task, [&] (const pcl::IndicesPtr& rest) {
    open3d::geometry::PointCloud cloud;
    for (const pcl::index_t i : *rest)
      cloud.points_.push_back ((*task.cloud)[i].getVector3fMap().cast<double>());
    const auto& [coefficients, indices] =
        cloud.SegmentPlane (task.values.threshold, points_of_sample, iterations);
    pcl::Indices inliers;
    for (const std::size_t i : indices)
      inliers.push_back ((*rest)[i]);
    return inliers;
  });
}

} // namespace pcl_ops::evaluation
