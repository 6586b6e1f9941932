// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "module.h"
#include <pcl_ops/plane_edges.h>
#include <pcl_ops/plane_filter.h>
#include <pcl_ops/plane_tracker.h>
#include <pcl_ops/up_axis.h>

#include <algorithm>

namespace pcl_ops::python {

namespace {

using PlaneSegments = std::vector<PlaneSegment>;

/** \brief What the planes put in share with the one they went into: its inliers, and
 * the normal of the largest. */
PlaneSegments
membersTogether (const PlaneSegments& planes, const MergedPlanes& merged)
{
  PlaneSegments all (merged.fits.size());
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const PlaneSegment& plane = planes[i];
    if (merged.merged_into[i] == no_plane)
      continue;
    PlaneSegment& whole = all[static_cast<std::size_t> (merged.merged_into[i])];
    whole.inliers.insert (
        whole.inliers.end(), plane.inliers.begin(), plane.inliers.end());
    if (plane.moments.count > whole.moments.count) {
      whole.moments.count = plane.moments.count;
      whole.normal = plane.normal;
    }
  }
  return all;
}

/** \return the planes after merging, and into which of them each plane went */
std::pair<PlaneSegments, Labels>
merge (const PlaneSegments& planes, const MergePlanesParameters& parameters)
{
  std::vector<Moments> moments;
  for (const PlaneSegment& plane : planes)
    moments.push_back (plane.moments);
  const MergedPlanes merged = mergePlanes (moments, parameters.merging);
  PlaneSegments all = membersTogether (planes, merged);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const PlaneFit& fit = merged.fits[i];
    const Eigen::Vector3d& normal = fit.plane.normal;
    all[i].normal = normal.dot (all[i].normal) < 0.0 ? -normal : normal;
    all[i].centroid = fit.centroid;
    all[i].moments = merged.moments[i].about (fit.centroid);
    std::sort (all[i].inliers.begin(), all[i].inliers.end());
  }
  nameOrientations (all, parameters.up_axis.cast<double>(), parameters.angle_tolerance);
  return {std::move (all), merged.merged_into};
}

/** \brief How many planes each argument drops. */
py::dict
byName (const DroppedPlanes& dropped)
{
  using py::arg;
  return py::dict (arg ("orientation") = dropped.by_orientation,
                   arg ("direction") = dropped.by_direction,
                   arg ("slope") = dropped.by_slope,
                   arg ("min_points") = dropped.by_points,
                   arg ("min_area") = dropped.by_area,
                   arg ("min_width") = dropped.by_width,
                   arg ("max_area") = dropped.by_max_area,
                   arg ("max_width") = dropped.by_max_width,
                   arg ("size") = dropped.by_size,
                   arg ("max_planes") = dropped.by_number);
}

/** \return the positions of those kept, and how many each argument drops */
py::tuple
filter (const py::list& planes, const PlaneFilter& filter)
{
  const auto segments = planes.cast<PlaneSegments>();
  const auto extent_of = [&] (const PlaneSegment& segment) {
    // What Python's Plane at the place of the segment knows.
    const py::object plane =
        planes[static_cast<std::size_t> (&segment - segments.data())];
    PlaneExtent extent;
    extent.area = plane.attr ("area").cast<double>();
    extent.length = plane.attr ("length").cast<double>();
    extent.width = plane.attr ("width").cast<double>();
    return extent;
  };
  DroppedPlanes dropped;
  const auto kept = keptPlanes (segments, filter, extent_of, dropped);
  return py::make_tuple (kept, byName (dropped));
}

std::pair<Labels, Eigen::Matrix4d>
match (const PlaneSegments& previous,
       const PlaneSegments& current,
       const Eigen::Matrix4d& pose,
       const PlaneMatchingParameters& parameters)
{
  const PlaneMatches matches =
      matchPlanes (previous, current, Eigen::Isometry3d (pose), parameters);
  return {matches.previous, matches.pose.matrix()};
}

/** \return direction and confidence, or nothing */
std::optional<std::pair<Eigen::Vector3d, double>>
upAxis (const PlaneSegments& planes,
        const Eigen::Vector3d& viewpoint,
        const UpAxisParameters& parameters)
{
  const std::optional<UpAxis> found = estimateUpAxis (planes, viewpoint, parameters);
  if (!found)
    return std::nullopt;
  return std::make_pair (found->direction, found->confidence);
}

/** \return (planes, start, end, angle) of each edge, (planes, position) of each corner
 */
py::tuple
edges (const PointRows& points,
       const Eigen::Vector3d& origin,
       const PlaneSegments& planes,
       const PlaneEdgeParameters& parameters)
{
  const PlaneEdges found = findPlaneEdges (viewOf (points), planes, parameters, origin);
  py::list edges, corners;
  for (const PlaneEdge& edge : found.edges)
    edges.append (py::make_tuple (
        py::tuple (py::cast (edge.planes)), edge.from, edge.to, edge.angle));
  for (const PlaneCorner& corner : found.corners)
    corners.append (
        py::make_tuple (py::tuple (py::cast (corner.planes)), corner.position));
  return py::make_tuple (edges, corners);
}

/** \return (number, plane, last_seen, first_seen, times_seen, hull) of each */
py::list
trackedPlanes (const PlaneTracker& tracker)
{
  py::list all;
  for (const TrackedPlane& one : tracker.planes())
    all.append (py::make_tuple (one.number,
                                one.plane,
                                one.last_seen,
                                one.first_seen,
                                one.times_seen,
                                one.extent.hull));
  return all;
}

void
defineTracker (py::module_& module)
{
  py::class_<PlaneTracker> (module, "Tracker")
      .def (py::init<PlaneMatchingParameters,
                     std::optional<std::size_t>,
                     std::optional<double>>())
      .def ("track",
            [] (PlaneTracker& tracker,
                const PlaneSegments& planes,
                const Eigen::Matrix4d& pose) {
              return tracker.track (planes, Eigen::Isometry3d (pose));
            })
      .def_property_readonly ("planes", &trackedPlanes)
      .def_property_readonly (
          "pose", [] (const PlaneTracker& tracker) { return tracker.pose().matrix(); })
      .def ("copy", [] (const PlaneTracker& tracker) { return tracker; });
}

} // namespace

void
defineListFunctions (py::module_& module)
{
  module.def ("merge", &merge);
  module.def ("filter", &filter);
  module.def ("match", &match);
  module.def ("up_axis", &upAxis);
  module.def ("edges", &edges);
  defineTracker (module);
}

} // namespace pcl_ops::python
