// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "plane_lists.h"

#include "given_parameters.h"
#include "point_rows.h"
#include <pcl_ops/plane_tracker.h>

#include <algorithm>

namespace pcl_ops::python {

namespace {

using PlaneSegments = std::vector<PlaneSegment>;

/** \brief The plane that some planes went into.
 * \param[in] members by falling size */
PlaneSegment
joined (const std::vector<const PlaneSegment*>& members,
        const Moments& moments,
        const PlaneFit& fit)
{
  PlaneSegment plane;
  plane.centroid = fit.centroid;
  const Eigen::Vector3d& normal = fit.plane.normal;
  plane.normal = normal.dot (members.front()->normal) < 0.0 ? -normal : normal;
  plane.moments = moments.about (fit.centroid);
  for (const PlaneSegment* member : members)
    plane.inliers.insert (
        plane.inliers.end(), member->inliers.begin(), member->inliers.end());
  std::sort (plane.inliers.begin(), plane.inliers.end());
  return plane;
}

PlaneSegments
joinedPlanes (const PlaneSegments& planes, const MergedPlanes& merged)
{
  std::vector<std::vector<const PlaneSegment*>> members (merged.fits.size());
  for (std::size_t i = 0; i < planes.size(); ++i)
    if (const std::int32_t into = merged.merged_into[i]; into != no_plane)
      members[static_cast<std::size_t> (into)].push_back (&planes[i]);
  PlaneSegments all;
  for (std::size_t i = 0; i < members.size(); ++i) {
    std::stable_sort (members[i].begin(), members[i].end(), [] (auto one, auto other) {
      return one->moments.count > other->moments.count;
    });
    all.push_back (joined (members[i], merged.moments[i], merged.fits[i]));
  }
  return all;
}

/** \return the planes after merging, and into which of them each plane went */
std::pair<PlaneSegments, Labels>
merge (const PlaneSegments& planes, const py::dict& given)
{
  const auto parameters = withGiven (MergePlanesParameters(), given);
  std::vector<Moments> moments;
  for (const PlaneSegment& plane : planes)
    moments.push_back (plane.moments);
  const MergedPlanes merged = mergePlanes (moments, parameters.merging);
  PlaneSegments found = joinedPlanes (planes, merged);
  nameOrientations (
      found, parameters.up_axis.cast<double>(), parameters.angle_tolerance);
  return {std::move (found), merged.merged_into};
}

/** \brief Filters one plane after the other, so that Python keeps its own objects.
 * \param[in] extent_of says (area, width) of the plane at a position
 * \return for each plane the argument that drops it, empty if none does */
std::vector<std::string>
filter (const PlaneSegments& planes,
        const py::dict& given,
        const py::function& extent_of)
{
  PlaneFilter filter = withGiven (PlaneFilter(), given);
  const auto most = std::exchange (filter.max_planes, std::nullopt);
  std::vector<std::string> reasons;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    PlaneSegments one = {planes[i]};
    const DroppedPlanes by = filterPlanes (one, filter, [&] (const PlaneSegment&) {
      PlaneExtent extent;
      std::tie (extent.area, extent.width) =
          extent_of (i).cast<std::tuple<double, double>>();
      return extent;
    });
    reasons.emplace_back (by.by_orientation != 0  ? "orientation"
                          : by.by_direction != 0  ? "direction"
                          : by.by_points != 0     ? "min_points"
                          : by.by_area != 0       ? "min_area"
                          : by.by_width != 0      ? "min_width"
                          : by.by_max_area != 0   ? "max_area"
                          : by.by_max_width != 0  ? "max_width"
                          : most && kept >= *most ? "max_planes"
                                                  : "");
    kept += reasons.back().empty() ? 1 : 0;
  }
  return reasons;
}

std::pair<Labels, Eigen::Matrix4d>
match (const PlaneSegments& previous,
       const PlaneSegments& current,
       const Eigen::Matrix4d& pose,
       const py::dict& given)
{
  const auto parameters = withGiven (PlaneMatchingParameters(), given);
  const PlaneMatches matches =
      matchPlanes (previous, current, Eigen::Isometry3d (pose), parameters);
  return {matches.previous, matches.pose.matrix()};
}

/** \return direction and confidence, or nothing */
std::optional<std::pair<Eigen::Vector3d, double>>
upAxis (const PlaneSegments& planes,
        const Eigen::Vector3d& viewpoint,
        const py::dict& given)
{
  const auto parameters = withGiven (UpAxisParameters(), given);
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
       const py::dict& given)
{
  const auto parameters = withGiven (PlaneEdgeParameters(), given);
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

void
defineTracker (py::module_& module)
{
  py::class_<TrackedPlane> (module, "TrackedPlane")
      .def_readonly ("number", &TrackedPlane::number)
      .def_readonly ("plane", &TrackedPlane::plane)
      .def_readonly ("last_seen", &TrackedPlane::last_seen);
  py::class_<PlaneTracker> (module, "Tracker")
      .def (py::init ([] (std::optional<std::size_t> memory, const py::dict& given) {
        return PlaneTracker (withGiven (PlaneMatchingParameters(), given), memory);
      }))
      .def ("track",
            [] (PlaneTracker& tracker,
                const PlaneSegments& planes,
                const Eigen::Matrix4d& pose) {
              return tracker.track (planes, Eigen::Isometry3d (pose));
            })
      .def_property_readonly ("planes", &PlaneTracker::planes)
      .def_property_readonly (
          "pose", [] (const PlaneTracker& tracker) { return tracker.pose().matrix(); })
      .def ("copy", [] (const PlaneTracker& tracker) { return tracker; })
      // Without it protocols 0 and 1 of pickle end the program in pybind11.
      .def ("__reduce_ex__", [] (const PlaneTracker&, int /*protocol*/) -> py::object {
        throw py::type_error ("cannot pickle 'pcl_ops.PlaneTracker' objects");
      });
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
