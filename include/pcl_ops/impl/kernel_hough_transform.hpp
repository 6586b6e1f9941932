// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/kernel_hough_transform.h>
#include <pcl_ops/stage_timer.h>

namespace pcl_ops {

template <typename PointT>
Detection
KernelHoughTransform<PointT>::detect()
{
  Detection found;
  found.points = finitePoints (*input_, *indices_);
  const Points& points = found.points;
  // octree: nodes of approximately coplanar points
  const OctreeClusters clusters = timed (durations_.search, [&] {
    return findCoplanarClusters (points, parameters_.clusters, parameters_.threads);
  });
  // accumulator ball: Gaussian kernels vote for (rho, phi, theta), peaks are planes
  const std::vector<Plane> planes = timed (
      durations_.extraction, [&] { return houghPlanes (clusters, parameters_); });
  // each point to the nearest plane within theta_h, or as published the first
  found.labels = timed (durations_.assignment, [&] {
    return assignOctreePoints (clusters, points.size(), planes, parameters_);
  });
  // section III-C of the OPS paper: the coplanarity test on each pair
  found.planes = timed (durations_.merging, [&] {
    return mergeLabelled (points,
                          found.labels,
                          planes.size(),
                          this->mergingParameters(),
                          parameters_.threads);
  });
  if (!parameters_.refit.enabled)
    restorePlanes (found.planes, planes);
  return found;
}

} // namespace pcl_ops

#define PCL_INSTANTIATE_KernelHoughTransform(T)                                        \
  template class PCL_EXPORTS pcl_ops::KernelHoughTransform<T>;
