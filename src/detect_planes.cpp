// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_ops/detect_planes.h>

#include <numeric>

namespace pcl_ops {

namespace {

template <typename Parameters>
std::vector<PlaneSegment>
detectIn (const CloudView& cloud,
          const Parameters& parameters,
          const Eigen::Vector3d& viewpoint)
{
  pcl::Indices all (cloud.size);
  std::iota (all.begin(), all.end(), 0);
  return detail::detectChecked ({cloud, all, viewpoint, nullptr}, parameters).planes;
}

} // namespace

std::vector<PlaneSegment>
detectPlanes (const CloudView& cloud,
              const OrientedPointSamplingParameters& parameters,
              const Eigen::Vector3d& viewpoint)
{
  return detectIn (cloud, parameters, viewpoint);
}

std::vector<PlaneSegment>
detectPlanes (const CloudView& cloud,
              const FastSamplingPlaneFilteringParameters& parameters,
              const Eigen::Vector3d& viewpoint)
{
  return detectIn (cloud, parameters, viewpoint);
}

std::vector<PlaneSegment>
detectPlanes (const CloudView& cloud,
              const KernelHoughTransformParameters& parameters,
              const Eigen::Vector3d& viewpoint)
{
  return detectIn (cloud, parameters, viewpoint);
}

} // namespace pcl_ops
