// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/console/print.h>
#include <pcl/search/kdtree.h>

#include <pcl_ops/grid_search.h>
#include <pcl_ops/plane_detector.h>
#include <pcl_ops/stage_timer.h>

#include <algorithm>
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
  durations_ = StageDurations();
  planes_before_merging_ = 0;
  try {
    if (!isReady())
      return false;
    planes = timed (durations_.detection, [this] {
      const Detection detection = static_cast<Detector&> (*this).detect();
      planes_before_merging_ = detection.planes.merged_into.size();
      return toSegments (detection, viewpoint(), parameters_);
    });
  }
  catch (const std::exception& error) {
    PCL_ERROR ("[pcl_ops::%s::segment] %s\n", getClassName().c_str(), error.what());
    planes.clear();
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
  coefficients.assign (planes.size(), pcl::ModelCoefficients());
  inliers.assign (planes.size(), pcl::PointIndices());
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const Plane plane = planes[i].plane();
    coefficients[i].header = inliers[i].header = this->input_->header;
    coefficients[i].values = {static_cast<float> (plane.normal.x()),
                              static_cast<float> (plane.normal.y()),
                              static_cast<float> (plane.normal.z()),
                              static_cast<float> (plane.offset)};
    inliers[i].indices.swap (planes[i].inliers);
  }
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
  std::string problem;
  if (!this->initCompute())
    problem = "no input cloud; call setInputCloud";
  else if (this->input_->empty())
    problem = "the input cloud is empty";
  else if (this->indices_->empty())
    problem = "the indices are empty; leave them out to use the whole cloud";
  else if (!hasIndicesInRange())
    problem = "an index lies outside the input cloud";
  else
    problem = problemOf (parameters_);
  if (!problem.empty())
    PCL_ERROR ("[pcl_ops::%s::segment] %s\n", getClassName().c_str(), problem.c_str());
  return problem.empty();
}

template <typename PointT, typename Detector, typename ParametersT>
bool
PlaneDetector<PointT, Detector, ParametersT>::hasIndicesInRange() const
{
  const std::size_t size = this->input_->size();
  return this->fake_indices_ ||
         std::all_of (
             this->indices_->begin(), this->indices_->end(), [size] (pcl::index_t i) {
               return i >= 0 && static_cast<std::size_t> (i) < size;
             });
}

template <typename PointT, typename Detector, typename ParametersT>
typename PlaneDetector<PointT, Detector, ParametersT>::SearchPtr
PlaneDetector<PointT, Detector, ParametersT>::searchOver (const Points& points) const
{
  if (!search_) {
    constexpr bool sorted_results = false;
    const auto grid = pcl::make_shared<GridSearch<PointT>> (sorted_results);
    grid->setInputCloud (this->input_, points);
    return grid;
  }
  const SearchPtr search = search_;
  if (points.size() == this->input_->size())
    search->setInputCloud (this->input_);
  else
    search->setInputCloud (this->input_,
                           pcl::IndicesConstPtr (new pcl::Indices (points.index)));
  return search;
}

template <typename PointT, typename Detector, typename ParametersT>
Eigen::Vector3d
PlaneDetector<PointT, Detector, ParametersT>::viewpoint() const
{
  return this->input_->sensor_origin_.template head<3>().template cast<double>();
}

template <typename PointT, typename Detector, typename ParametersT>
unsigned
PlaneDetector<PointT, Detector, ParametersT>::searchThreads() const
{
  const Search* const search = search_.get();
  const bool is_safe = !search || dynamic_cast<const GridSearch<PointT>*> (search) ||
                       dynamic_cast<const pcl::search::KdTree<PointT>*> (search);
  return is_safe ? parameters_.threads : 1;
}

template <typename PointT, typename Detector, typename ParametersT>
MergingParameters
PlaneDetector<PointT, Detector, ParametersT>::mergingParameters() const
{
  MergingParameters merging = parameters_.merging;
  if (merging.distance_threshold == 0.0)
    merging.distance_threshold = parameters_.distance_threshold;
  return merging;
}

} // namespace pcl_ops
