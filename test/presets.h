// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <pcl_ops/oriented_point_sampling.h>

#include <functional>
#include <string>
#include <vector>

using Ops = pcl_ops::OrientedPointSampling<pcl::PointXYZ>;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;

/** \brief A cloud of \p size points.
 * \param[in] pointOfIndex returns the point with an index: 0, 1, ... size - 1 */
inline Cloud::Ptr
cloudOf (std::size_t size, const std::function<pcl::PointXYZ (float)>& pointOfIndex)
{
  const auto cloud = pcl::make_shared<Cloud>();
  for (std::size_t i = 0; i < size; ++i)
    cloud->push_back (pointOfIndex (static_cast<float> (i)));
  return cloud;
}

/** \brief OPS with a sampling rate of 10 %: enough samples for a small scene. */
inline Ops
opsOn (const Cloud::ConstPtr& cloud, const Ops::Parameters& parameters = {})
{
  Ops ops;
  ops.setParameters (parameters);
  ops.setSamplingRate (0.1);
  ops.setInputCloud (cloud);
  return ops;
}

/** \brief \ref opsOn with this kind of samples; all other parameters are defaults. */
inline Ops
sampledOn (pcl_ops::Sampling sampling, const Cloud::ConstPtr& cloud)
{
  Ops::Parameters parameters;
  parameters.sampling = sampling;
  return opsOn (cloud, parameters);
}

/** \brief \ref opsOn on voxels: its samples are flat voxels with a normal (surfels). */
inline Ops
voxelsOn (const Cloud::ConstPtr& cloud)
{
  return sampledOn (pcl_ops::Sampling::Surfels, cloud);
}

/** \brief OPS with the parameters of the paper. */
inline Ops
paperOn (const Cloud::ConstPtr& cloud)
{
  return opsOn (cloud, Ops::Parameters::paper());
}

/** \brief The planes that a detector finds in its cloud. The test fails if the detector
 * refuses the cloud. */
template <typename Detector>
std::vector<pcl_ops::PlaneSegment>
planesOf (Detector& detector)
{
  std::vector<pcl_ops::PlaneSegment> planes;
  EXPECT_TRUE (detector.segment (planes));
  return planes;
}

/** \brief The indices of the inliers of each plane. */
template <typename Detector>
std::vector<pcl::Indices>
inliersOf (Detector& detector)
{
  std::vector<pcl::Indices> inliers;
  for (const pcl_ops::PlaneSegment& plane : planesOf (detector))
    inliers.push_back (plane.inliers);
  return inliers;
}
