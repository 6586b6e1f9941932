// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/kernel_hough_transform.h>
#include <pcl_ops/stage_timer.h>

#include <utility>

namespace pcl_ops {

template <typename PointT>
Detection
KernelHoughTransform<PointT>::detect()
{
  KernelHoughTransformParameters parameters = parameters_;
  parameters.merging = this->mergingParameters();
  Points points = finitePoints (*input_, *indices_, parameters_.threads);
  // octree: nodes of approximately coplanar points
  const OctreeClusters clusters = timed (durations_.search, [&] {
    return findCoplanarClusters (points, parameters.clusters, parameters.threads);
  });
  // accumulator ball: Gaussian kernels vote for (rho, phi, theta), peaks are planes
  const std::vector<HoughPlane> planes =
      timed (durations_.extraction, [&] { return houghPlanes (clusters, parameters); });
  // every point to a plane, and the coplanarity test of the OPS paper on each pair
  const auto assign = parameters.refit.enabled && parameters.bounded
                          ? assignToOutlinedPlanes
                          : assignToEndlessPlanes;
  return assign (std::move (points), clusters, planes, parameters, durations_);
}

} // namespace pcl_ops

#define PCL_INSTANTIATE_KernelHoughTransform(T)                                        \
  template class PCL_EXPORTS pcl_ops::KernelHoughTransform<T>;
