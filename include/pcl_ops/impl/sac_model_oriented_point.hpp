// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/plane.h>
#include <pcl_ops/sac_model_oriented_point.h>

#include <cmath>

namespace pcl_ops {

template <typename PointNT>
SampleConsensusModelOrientedPoint<PointNT>::SampleConsensusModelOrientedPoint (
    const PointCloudConstPtr& cloud, bool random)
: Base (cloud, random)
{
  this->model_name_ = "SampleConsensusModelOrientedPoint";
  this->sample_size_ = 1;
}

template <typename PointNT>
SampleConsensusModelOrientedPoint<PointNT>::SampleConsensusModelOrientedPoint (
    const PointCloudConstPtr& cloud, const pcl::Indices& indices, bool random)
: Base (cloud, indices, random)
{
  this->model_name_ = "SampleConsensusModelOrientedPoint";
  this->sample_size_ = 1;
}

template <typename PointNT>
void
SampleConsensusModelOrientedPoint<PointNT>::setSeed (std::uint32_t seed)
{
  this->rng_alg_.seed (seed);
  // PCL draws samples by further shuffling shuffled_indices_: reset their order, too.
  this->shuffled_indices_ = *this->indices_;
}

template <typename PointNT>
bool
SampleConsensusModelOrientedPoint<PointNT>::isSampleGood (
    const pcl::Indices& samples) const
{
  if (samples.size() != 1)
    return false;
  const PointNT& point = (*this->input_)[samples.front()];
  const auto normal = point.getNormalVector3fMap();
  const float squared_length = normal.squaredNorm(); // infinite for huge normals
  return point.getVector3fMap().allFinite() && squared_length > 0.0f &&
         std::isfinite (squared_length);
}

template <typename PointNT>
bool
SampleConsensusModelOrientedPoint<PointNT>::computeModelCoefficients (
    const pcl::Indices& samples, Eigen::VectorXf& model_coefficients) const
{
  if (!isSampleGood (samples))
    return false;
  const PointNT& point = (*this->input_)[samples.front()];
  const Eigen::Vector3f normal = point.getNormalVector3fMap().normalized();
  model_coefficients.resize (4);
  for (int axis = 0; axis < 3; ++axis)
    model_coefficients[axis] = normal[axis];
  model_coefficients[3] = -normal.dot (point.getVector3fMap());
  return true;
}

template <typename PointNT>
void
SampleConsensusModelOrientedPoint<PointNT>::optimizeModelCoefficients (
    const pcl::Indices& inliers,
    const Eigen::VectorXf& model_coefficients,
    Eigen::VectorXf& optimized_coefficients) const
{
  optimized_coefficients = model_coefficients;
  if (inliers.empty() || !this->isModelValid (model_coefficients))
    return;
  const PointNT& first = (*this->input_)[inliers.front()];
  const Eigen::Vector3d origin = first.getVector3fMap().template cast<double>();
  Moments moments{origin};
  for (const pcl::index_t i : inliers) {
    const PointNT& point = (*this->input_)[i];
    moments.add (point.x - origin.x(), point.y - origin.y(), point.z - origin.z());
  }
  const std::optional<PlaneFit> fit = fitPlane (moments);
  if (!fit)
    return;
  const Eigen::Vector3d model_normal = model_coefficients.head<3>().cast<double>();
  const double sign = fit->plane.normal.dot (model_normal) < 0.0 ? -1.0 : 1.0;
  for (int axis = 0; axis < 3; ++axis)
    optimized_coefficients[axis] = static_cast<float> (sign * fit->plane.normal[axis]);
  optimized_coefficients[3] = static_cast<float> (sign * fit->plane.offset);
  if (!this->isModelValid (optimized_coefficients))
    optimized_coefficients = model_coefficients;
}

} // namespace pcl_ops

// Compiles the model for the point type T, as PCL_INSTANTIATE asks for.
#define PCL_INSTANTIATE_SampleConsensusModelOrientedPoint(T)                           \
  template class PCL_OPS_EXPORT pcl_ops::SampleConsensusModelOrientedPoint<T>;
