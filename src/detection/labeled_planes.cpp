// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/labeled_planes.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace pcl_ops::internal {
namespace {

// Makes a segment in the local frame, with the normal towards the viewpoint. Its list
// of inliers has the right size, but is not filled in yet.
PlaneSegment
toSegment (const Moments& moments,
           const PlaneFit& fit,
           const std::optional<double>& noise,
           const Eigen::Vector3d& local_viewpoint)
{
  const bool faces_viewpoint = fit.plane.distance (local_viewpoint) >= 0.0;
  return {fit.centroid,
          faces_viewpoint ? fit.plane.normal : Eigen::Vector3d (-fit.plane.normal),
          Orientation::Other,
          moments.about (fit.centroid),
          pcl::Indices (static_cast<std::size_t> (moments.count)),
          noise};
}

// Writes the indices of the points of each label to its segment, whose list of inliers
// has the right size. Successive points mostly share a plane, so the inner loop keeps
// the pointer to the next inlier in a register.
void
fillInInliers (const Points& points,
               const Labels& labels,
               std::vector<PlaneSegment>& segments)
{
  std::vector<pcl::index_t*> next; // where to write the next inlier of each segment
  for (PlaneSegment& segment : segments)
    next.push_back (segment.inliers.data());
  for (std::size_t i = 0; i < labels.size();) {
    const std::int32_t label = labels[i];
    if (label == no_plane) {
      ++i;
      continue;
    }
    pcl::index_t* write_to = next[label];
    for (; i < labels.size() && labels[i] == label; ++i)
      *write_to++ = points.indexOf (i);
    next[label] = write_to;
  }
  for (const Copy& copy : points.copies)
    if (const std::int32_t label = labels[copy.point]; label != no_plane)
      *next[label]++ = copy.index;
  if (!points.copies.empty())
    for (PlaneSegment& segment : segments)
      std::sort (segment.inliers.begin(), segment.inliers.end());
}

// Sorts planes by descending number of points, and changes labels and merged_into to
// the new indices of the planes.
void
sortByDescendingCount (LabeledPlanes& found)
{
  MergedPlanes& planes = found.planes;
  std::vector<std::size_t> order (planes.moments.size());
  std::iota (order.begin(), order.end(), 0);
  std::stable_sort (order.begin(), order.end(), [&] (std::size_t a, std::size_t b) {
    return planes.moments[a].count > planes.moments[b].count;
  });
  MergedPlanes sorted;
  std::vector<std::optional<double>> sorted_noises;
  Labels new_label (order.size());
  for (const std::size_t p : order) {
    new_label[p] = static_cast<std::int32_t> (sorted.moments.size());
    sorted.moments.push_back (planes.moments[p]);
    sorted.fits.push_back (planes.fits[p]);
    if (!found.noises.empty())
      sorted_noises.push_back (found.noises[p]);
  }
  constexpr unsigned one_thread = 1;
  relabel (found.labels, new_label, one_thread);
  relabel (planes.merged_into, new_label, one_thread);
  sorted.merged_into = std::move (planes.merged_into);
  planes = std::move (sorted);
  found.noises = std::move (sorted_noises);
}

} // namespace

ChosenPoints::ChosenPoints (const DetectorInput& input) : cloud_ (input.cloud)
{
  if (!input.indices)
    return;
  chosen_.emplace();
  for (const pcl::index_t i : *input.indices)
    chosen_->insert (chosen_->end(), input.cloud[i], input.cloud[i] + 3);
}

CloudView
ChosenPoints::view() const
{
  constexpr std::size_t numbers = 3; // of a point
  return chosen_ ? CloudView (chosen_->data(),
                              0,
                              numbers * sizeof (float),
                              chosen_->size() / numbers)
                 : cloud_;
}

LabeledPlanes
mergePlanesOf (AssignedPoints assigned,
               const MergingParameters& parameters,
               unsigned threads)
{
  LabeledPlanes found{std::move (assigned.labels),
                      mergePlanes (assigned.moments, parameters),
                      assigned.moments.size()};
  relabel (found.labels, found.planes.merged_into, threads);
  return found;
}

void
addCopies (const Points& points, LabeledPlanes& found)
{
  MergedPlanes& planes = found.planes;
  for (const Copy& copy : points.copies)
    if (const std::int32_t label = found.labels[copy.point]; label != no_plane) {
      Moments& moments = planes.moments[label];
      const Eigen::Vector3d offset = points[copy.point] - moments.origin;
      moments.add (offset.x(), offset.y(), offset.z());
    }
  for (std::size_t p = 0; p < planes.fits.size(); ++p) {
    // The centroid of all points, copies included, moved onto the plane.
    PlaneFit& fit = planes.fits[p];
    fit.centroid = planes.moments[p].centroid();
    fit.centroid -= fit.plane.distance (fit.centroid) * fit.plane.normal;
  }
  sortByDescendingCount (found);
}

std::vector<PlaneSegment>
toSegments (const Points& points,
            const LabeledPlanes& found,
            const Eigen::Vector3d& viewpoint)
{
  std::vector<PlaneSegment> segments;
  for (std::size_t p = 0; p < found.planes.fits.size(); ++p)
    segments.push_back (
        toSegment (found.planes.moments[p],
                   found.planes.fits[p],
                   found.noises.empty() ? std::nullopt : found.noises[p],
                   viewpoint - points.origin));
  fillInInliers (points, found.labels, segments);
  for (PlaneSegment& segment : segments)
    segment.moveBy (points.origin);
  return segments;
}

void
dropSmallPlanes (std::size_t min_points, std::vector<PlaneSegment>& planes)
{
  const auto isSmall = [=] (const PlaneSegment& plane) {
    return plane.inliers.size() < min_points;
  };
  planes.erase (std::remove_if (planes.begin(), planes.end(), isSmall), planes.end());
}

} // namespace pcl_ops::internal
