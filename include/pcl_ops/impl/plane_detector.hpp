// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/console/print.h>

#include <pcl_ops/plane_detector.h>
#include <pcl_ops/plane_extent.h>

#include <exception>

namespace pcl_ops {

template <typename PointT>
pcl::PlanarRegion<PointT>
toRegion (const pcl::PointCloud<PointT>& cloud, const PlaneSegment& segment)
{
  typename pcl::PointCloud<PointT>::VectorType contour;
  for (const Eigen::Vector3d& corner : planeExtent (cloud, segment).hull) {
    PointT point{};
    point.x = static_cast<float> (corner.x());
    point.y = static_cast<float> (corner.y());
    point.z = static_cast<float> (corner.z());
    contour.push_back (point);
  }
  const Plane plane = segment.plane();
  Eigen::Vector4f coefficients;
  coefficients << plane.normal.cast<float>(), static_cast<float> (plane.offset);
  return {segment.centroid.cast<float>(),
          segment.moments.covariance().template cast<float>(),
          static_cast<unsigned> (segment.inliers.size()),
          contour,
          coefficients};
}

template <typename PointT, typename Detector, typename ParametersT>
bool
PlaneDetector<PointT, Detector, ParametersT>::segment (
    std::vector<PlaneSegment>& planes)
{
  planes.clear();
  last_ = Detection();
  try {
    if (!isReady())
      return false;
    last_ = detectPlanes (input(), parameters_);
    planes.swap (last_.planes);
  }
  catch (const std::exception& error) {
    PCL_ERROR ("[pcl_ops::%s::segment] %s\n", getClassName().c_str(), error.what());
    last_ = Detection();
    return false;
  }
  this->deinitCompute();
  return true;
}

template <typename PointT, typename Detector, typename ParametersT>
bool
PlaneDetector<PointT, Detector, ParametersT>::segment (
    std::vector<pcl::ModelCoefficients>& coefficients,
    std::vector<pcl::PointIndices>& inliers)
{
  std::vector<PlaneSegment> planes;
  const bool success = segment (planes);
  toModels (planes,
            this->input_ ? this->input_->header : pcl::PCLHeader(),
            coefficients,
            inliers);
  return success;
}

template <typename PointT, typename Detector, typename ParametersT>
bool
PlaneDetector<PointT, Detector, ParametersT>::segment (
    pcl::PointIndices& inliers, pcl::ModelCoefficients& coefficients)
{
  std::vector<pcl::PointIndices> all_inliers;
  std::vector<pcl::ModelCoefficients> all_coefficients;
  const bool success = segment (all_coefficients, all_inliers);
  inliers = all_inliers.empty() ? pcl::PointIndices() : all_inliers.front();
  coefficients =
      all_coefficients.empty() ? pcl::ModelCoefficients() : all_coefficients.front();
  if (success && all_inliers.empty())
    inliers.header = coefficients.header = this->input_->header;
  return success;
}

template <typename PointT, typename Detector, typename ParametersT>
bool
PlaneDetector<PointT, Detector, ParametersT>::segment (PlanarRegions& regions)
{
  std::vector<PlaneSegment> planes;
  const bool success = segment (planes);
  regions.clear();
  for (const PlaneSegment& plane : planes)
    regions.push_back (toRegion (*this->input_, plane));
  return success;
}

template <typename PointT, typename Detector, typename ParametersT>
bool
PlaneDetector<PointT, Detector, ParametersT>::extract (
    std::vector<pcl::PointIndices>& clusters)
{
  std::vector<pcl::ModelCoefficients> coefficients;
  return segment (coefficients, clusters);
}

template <typename PointT, typename Detector, typename ParametersT>
bool
PlaneDetector<PointT, Detector, ParametersT>::isReady()
{
  std::string problem = "no input cloud; call setInputCloud";
  if (this->initCompute())
    problem = problemOf (input());
  if (problem.empty())
    problem = problemOf (parameters_);
  if (!problem.empty())
    PCL_ERROR ("[pcl_ops::%s::segment] %s\n", getClassName().c_str(), problem.c_str());
  return problem.empty();
}

template <typename PointT, typename Detector, typename ParametersT>
DetectorInput
PlaneDetector<PointT, Detector, ParametersT>::input() const
{
  DetectorInput input{
      CloudView (*this->input_),
      *this->indices_,
      this->input_->sensor_origin_.template head<3>().template cast<double>(),
      nullptr};
  if (search_)
    input.search_over = [this] (const pcl::Indices& finite) {
      return searchOver (finite);
    };
  return input;
}

template <typename PointT, typename Detector, typename ParametersT>
NeighbourSearch
PlaneDetector<PointT, Detector, ParametersT>::searchOver (
    const pcl::Indices& finite) const
{
  const bool are_all = finite.empty();
  search_->setInputCloud (
      this->input_, are_all ? nullptr : pcl::make_shared<const pcl::Indices> (finite));
  NeighbourSearch search;
  search.nearest = [this] (pcl::index_t point,
                           int k,
                           pcl::Indices& neighbours,
                           std::vector<float>& squared_distances) {
    search_->nearestKSearch ((*this->input_)[point], k, neighbours, squared_distances);
  };
  search.within = [this] (pcl::index_t point,
                          double radius,
                          pcl::Indices& neighbours,
                          std::vector<float>& squared_distances) {
    search_->radiusSearch (
        (*this->input_)[point], radius, neighbours, squared_distances);
  };
  // Only GridSearch and kd-trees are known to be safe to ask from several threads at
  // once.
  const std::string& name = search_->getName();
  const bool is_safe = name == "GridSearch" || name == "KdTree";
  search.threads = is_safe ? parameters_.threads : 1;
  return search;
}

} // namespace pcl_ops

/** The calls are those of the base, instantiated with each detector. */
#define PCL_OPS_INSTANTIATE_DETECTOR(Detector, T)                                      \
  template class PCL_OPS_EXPORT                                                        \
      pcl_ops::PlaneDetector<T, pcl_ops::Detector<T>, pcl_ops::Detector##Parameters>;  \
  template class PCL_OPS_EXPORT pcl_ops::Detector<T>;

#define PCL_INSTANTIATE_OrientedPointSampling(T)                                       \
  PCL_OPS_INSTANTIATE_DETECTOR (OrientedPointSampling, T)
#define PCL_INSTANTIATE_FastSamplingPlaneFiltering(T)                                  \
  PCL_OPS_INSTANTIATE_DETECTOR (FastSamplingPlaneFiltering, T)
#define PCL_INSTANTIATE_KernelHoughTransform(T)                                        \
  PCL_OPS_INSTANTIATE_DETECTOR (KernelHoughTransform, T)
