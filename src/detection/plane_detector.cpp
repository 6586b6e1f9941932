// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/console/print.h>

#include "geometry/angles.h"
#include <pcl_ops/plane_detector.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <stdexcept>
#include <type_traits>

namespace pcl_ops {

using namespace internal;

namespace {

std::string
validate (const MergingParameters& merging)
{
  if (!(merging.angle_threshold >= 0.0 && merging.angle_threshold <= right_angle))
    return "the merging angle must be between 0 and pi/2 (radians)";
  if (merging.distance_threshold && !(*merging.distance_threshold >= 0.0 &&
                                      std::isfinite (*merging.distance_threshold)))
    return "the merging distance must be a length, or not be given";
  if (merging.noise_factor &&
      !(*merging.noise_factor >= 0.0 && std::isfinite (*merging.noise_factor)))
    return "the merging noise factor must be 0 or more, or not be given";
  return {};
}

// Negative ones are the largest. Without a way out of the loop, so that it is
// vectorized.
std::size_t
largestOf (const pcl::Indices& indices)
{
  using Number = std::make_unsigned_t<pcl::index_t>;
  Number largest = 0;
  for (const pcl::index_t index : indices)
    largest = std::max (largest, static_cast<Number> (index));
  return largest;
}

} // namespace

std::string
validate (const PlaneDetectorParameters& parameters)
{
  if (parameters.distance_threshold &&
      !(*parameters.distance_threshold > 0.0 &&
        std::isfinite (*parameters.distance_threshold)))
    return "the distance threshold must be a length above 0";
  if (!parameters.up_axis.allFinite() || parameters.up_axis.isZero (0.0f))
    return "the up axis must be a finite vector other than zero";
  if (!(parameters.angle_tolerance >= 0.0 && parameters.angle_tolerance <= right_angle))
    return "the angle tolerance must be between 0 and pi/2 (radians)";
  return validate (parameters.merging);
}

namespace detail {

std::string
validate (const DetectorInput& input)
{
  if (input.cloud.size == 0)
    return "the input cloud is empty";
  if (input.indices.empty())
    return "the indices are empty; leave them out to use the whole cloud";
  if (largestOf (input.indices) >= input.cloud.size)
    return "an index lies outside the input cloud";
  return {};
}

void
toModels (std::vector<PlaneSegment>& planes,
          const pcl::PCLHeader& header,
          std::vector<pcl::ModelCoefficients>& coefficients,
          std::vector<pcl::PointIndices>& inliers)
{
  coefficients.assign (planes.size(), pcl::ModelCoefficients());
  inliers.assign (planes.size(), pcl::PointIndices());
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const Plane plane = planes[i].plane();
    coefficients[i].header = inliers[i].header = header;
    coefficients[i].values = {static_cast<float> (plane.normal.x()),
                              static_cast<float> (plane.normal.y()),
                              static_cast<float> (plane.normal.z()),
                              static_cast<float> (plane.offset)};
    inliers[i].indices.swap (planes[i].inliers);
  }
}

void
toLargestModel (std::vector<PlaneSegment>& planes,
                const pcl::PCLHeader& header,
                pcl::PointIndices& inliers,
                pcl::ModelCoefficients& coefficients)
{
  planes.resize (std::min<std::size_t> (planes.size(), 1));
  std::vector<pcl::ModelCoefficients> models;
  std::vector<pcl::PointIndices> clusters;
  toModels (planes, header, models, clusters);
  inliers = clusters.empty() ? pcl::PointIndices() : clusters.front();
  coefficients = models.empty() ? pcl::ModelCoefficients() : models.front();
  inliers.header = coefficients.header = header;
}

bool
runAndReport (const std::string& class_name, const std::function<void()>& detect)
{
  try {
    detect();
    return true;
  }
  catch (const std::exception& error) {
    PCL_ERROR ("[pcl_ops::%s::segment] %s\n", class_name.c_str(), error.what());
    return false;
  }
}

void
throwOn (const std::string& problem)
{
  if (!problem.empty())
    throw std::invalid_argument (problem);
}

} // namespace detail

} // namespace pcl_ops
