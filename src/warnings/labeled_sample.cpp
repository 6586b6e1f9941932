// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "warnings/labeled_sample.h"

#include "warnings/constants.h"

#include <stdexcept>

namespace pcl_ops::internal {

namespace {

/** \brief For each point of a cloud of so many points the position of its plane in the
 * list of planes, or no_plane.
 * \throw std::invalid_argument if an inlier is no point of the cloud */
Labels
labelsOfPoints (std::size_t points, const std::vector<PlaneSegment>& planes)
{
  Labels labels (points, no_plane);
  for (std::size_t p = 0; p < planes.size(); ++p)
    for (const pcl::index_t index : planes[p].inliers) {
      if (index < 0 || static_cast<std::size_t> (index) >= points)
        throw std::invalid_argument ("an inlier is no point of the cloud");
      labels[static_cast<std::size_t> (index)] = static_cast<std::int32_t> (p);
    }
  return labels;
}

} // namespace

LabeledSample
sampleWithLabels (const CloudView& cloud,
                  const std::vector<PlaneSegment>& planes,
                  const Eigen::Vector3d& shift)
{
  const Labels labels = labelsOfPoints (cloud.size, planes);
  constexpr unsigned one_thread = 1;
  const Points points = finitePoints (cloud, one_thread);
  const Indices sampled = sampleIndices (points, warning_constants.sampled_points);
  LabeledSample sample;
  sample.points = selected (points, sampled);
  sample.origin = points.origin + shift;
  sample.finite_points = points.size();
  for (const PlaneSegment& plane : planes)
    sample.points_on_planes += plane.inliers.size();
  for (const std::uint32_t index : sampled)
    sample.labels.push_back (labels[static_cast<std::size_t> (points.indexOf (index))]);
  return sample;
}

} // namespace pcl_ops::internal
