// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/labelled_planes.h"

#include <utility>

namespace pcl_ops::internal {
namespace {

PlaneSegment
toSegment (const Moments& moments,
           const PlaneFit& fit,
           const Eigen::Vector3d& local_viewpoint)
{
  const bool faces_sensor = fit.plane.distance (local_viewpoint) >= 0.0;
  return {fit.centroid,
          faces_sensor ? fit.plane.normal : Eigen::Vector3d (-fit.plane.normal),
          Orientation::Other,
          moments.about (fit.centroid),
          pcl::Indices (static_cast<std::size_t> (moments.count))};
}

// Writes each label's indices to its segment, which has room for them. Points that
// follow each other mostly share a plane: its place to write to stays in a register.
void
addInliers (const Points& points,
            const Labels& labels,
            std::vector<PlaneSegment>& segments)
{
  std::vector<pcl::index_t*> next;
  for (PlaneSegment& segment : segments)
    next.push_back (segment.inliers.data());
  for (std::size_t i = 0; i < labels.size();) {
    const std::int32_t label = labels[i];
    if (label == no_plane) {
      ++i;
      continue;
    }
    pcl::index_t* place = next[label];
    for (; i < labels.size() && labels[i] == label; ++i)
      *place++ = points.indexOf (i);
    next[label] = place;
  }
}

} // namespace

LabelledPlanes
mergeAssigned (AssignedPoints assigned,
               const MergingParameters& parameters,
               unsigned threads)
{
  LabelledPlanes found{std::move (assigned.labels),
                       mergePlanes (assigned.moments, parameters),
                       assigned.moments.size()};
  relabel (found.labels, found.planes.merged_into, threads);
  return found;
}

std::vector<PlaneSegment>
toSegments (const Points& points,
            const LabelledPlanes& found,
            const Eigen::Vector3d& viewpoint)
{
  std::vector<PlaneSegment> segments;
  for (std::size_t p = 0; p < found.planes.fits.size(); ++p)
    segments.push_back (toSegment (
        found.planes.moments[p], found.planes.fits[p], viewpoint - points.origin));
  addInliers (points, found.labels, segments);
  for (PlaneSegment& segment : segments)
    segment.moveBy (points.origin);
  return segments;
}

} // namespace pcl_ops::internal
