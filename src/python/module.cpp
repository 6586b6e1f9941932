// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
// The compiled part of the package. Users call the Python code beside it, which has the
// documentation and checks arrays.
#include "interpreter.h"
#include "parameters.h"
#include <metrics/metrics.h>
#include <pcl_ops/buildings/floor_plan.h>
#include <pcl_ops/buildings/plane_kinds.h>
#include <pcl_ops/buildings/plane_regularization.h>
#include <pcl_ops/detect_planes.h>
#include <pcl_ops/plane_extent.h>
#include <pcl_ops/plane_pieces.h>
#include <pcl_ops/plane_tracker.h>
#include <pcl_ops/result_warnings.h>
#include <pcl_ops/surface/concave_hull.h>
#include <pcl_ops/visibility.h>
#include <pybind11/numpy.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <numeric>

namespace pcl_ops::python {

namespace {

/** \brief Points as the package's own Python code hands them over: aligned, of shape
 * (N, 3), each row contiguous, rows at ascending addresses. */
using PointRows = py::array_t<float>;
using PlaneSegments = std::vector<PlaneSegment>;

/** \brief A view of the points, without a copy. */
CloudView
viewOf (const PointRows& points)
{
  constexpr std::size_t x_offset = 0; // [bytes]
  return {points.data(),
          x_offset,
          static_cast<std::size_t> (points.strides (0)),
          static_cast<std::size_t> (points.shape (0))};
}

/** \brief The axes u and v of the plane's frame, one in each row. */
Eigen::Matrix<double, 2, 3>
axesOf (const PlaneSegment& plane)
{
  const PlaneFrame frame (plane.centroid, plane.normal);
  Eigen::Matrix<double, 2, 3> axes;
  axes.row (0) = frame.directionInSpace (Eigen::Vector2d::UnitX());
  axes.row (1) = frame.directionInSpace (Eigen::Vector2d::UnitY());
  return axes;
}

/** \brief The matrix alone, which becomes an array; None for nothing. */
std::optional<Eigen::Matrix3d>
matrixOf (const std::optional<PlaneCovariance>& covariance)
{
  return covariance ? std::make_optional (covariance->matrix) : std::nullopt;
}

using Inliers = Eigen::Matrix<pcl::index_t, Eigen::Dynamic, 1>;

/** \brief Makes a plane from the values in a pickle; count, sum and products are those
 * of its moments about \p origin. */
PlaneSegment
segmentOf (const Eigen::Vector3d& centroid,
           const Eigen::Vector3d& normal,
           Orientation orientation,
           const Eigen::Vector3d& origin,
           double count,
           const Eigen::Vector3d& sum,
           const std::array<double, 6>& products,
           const Inliers& inliers,
           const std::optional<double>& noise)
{
  const Moments moments{origin, count, sum, products};
  return {
      centroid, normal, orientation, moments, {inliers.begin(), inliers.end()}, noise};
}

/** \brief Defines the class Segment, base of Python's Plane. A Segment made from
 * another one takes the contents out of that one. */
void
defineSegment (py::module_& module)
{
  py::class_<PlaneSegment> (module, "Segment")
      .def (py::init ([] (PlaneSegment& taken) { return std::move (taken); }))
      .def (py::init (&segmentOf))
      .def_readonly ("normal", &PlaneSegment::normal)
      .def_readonly ("centroid", &PlaneSegment::centroid)
      .def_property_readonly ("rms", &PlaneSegment::rms)
      .def_readonly ("noise", &PlaneSegment::noise)
      .def_readonly ("orientation", &PlaneSegment::orientation)
      .def_property_readonly (
          "inliers", // a view without a copy, which keeps the plane alive
          [] (const PlaneSegment& p) {
            const Eigen::Index size = p.inliers.size();
            return Eigen::Map<const Inliers> (p.inliers.data(), size);
          })
      .def_property_readonly ("axes", &axesOf)
      .def_property_readonly ("independent_covariance",
                              [] (const PlaneSegment& p) {
                                return matrixOf (independentPlaneCovariance (p));
                              })
      .def_property_readonly ("_moments", [] (const PlaneSegment& p) {
        const auto& [origin, count, sum, products] = p.moments;
        return std::make_tuple (origin, count, sum, products);
      });
}

/** \brief Finds the planes of points.
 * \return the planes in the frame of the user's array, the voxel size and the distance
 * threshold that were used
 * \param[in] points relative to \p origin
 * \param[in] origin, viewpoint in the frame of the user's array */
template <typename Parameters>
std::tuple<PlaneSegments, std::optional<double>, std::optional<double>>
segment (const PointRows& points,
         const Eigen::Vector3d& origin,
         const Eigen::Vector3d& viewpoint,
         const Parameters& parameters)
{
  Eigen::Vector3d local_viewpoint = viewpoint - origin;
  if (local_viewpoint.isZero (0.0) && !viewpoint.isZero (0.0)) // known: not zero
    local_viewpoint.z() = std::numeric_limits<double>::min();
  const detail::DetectorInput input{viewOf (points), nullptr, local_viewpoint, {}};
  detail::Detection found;
  whileOthersRun ([&] { found = detail::detectChecked (input, parameters); });
  // A viewpoint of zero may mean that no sensor is known: if the points were not seen
  // from there, normals are turned up. The detector got it relative to the origin,
  // where it is not zero, so this is done here.
  if (viewpoint.isZero (0.0) && !origin.isZero (0.0))
    turnUnseenUp (input.cloud,
                  input.viewpoint,
                  parameters.up_axis.template cast<double>(),
                  found.planes);
  for (PlaneSegment& plane : found.planes)
    plane.moveBy (origin);
  return {
      std::move (found.planes), found.used.voxel_size, found.used.distance_threshold};
}

/** \brief Divides planes into connected pieces.
 * \return the pieces, and for each piece the position of its plane
 * \param[in] points relative to \p origin
 * \param[in] max_gap widest gap within a piece [spacing of the points around it] */
std::pair<PlaneSegments, std::vector<std::size_t>>
pieces (const PointRows& points,
        const Eigen::Vector3d& origin,
        PlaneSegments planes,
        double max_gap,
        unsigned threads)
{
  for (PlaneSegment& plane : planes)
    plane.moveBy (-origin);
  PlanePiecesParameters parameters;
  parameters.max_gap = max_gap;
  PlanePieces found;
  whileOthersRun (
      [&] { found = findPlanePieces (viewOf (points), planes, parameters, threads); });
  for (PlaneSegment& piece : found.pieces)
    piece.moveBy (origin);
  return {std::move (found.pieces), std::move (found.planes)};
}

/** \brief The plane as one of a cloud that has only its inliers, in their order.
 * \param[in] origin zero of that cloud's frame in the frame of the plane */
PlaneSegment
inCloudOfInliers (PlaneSegment plane, const Eigen::Vector3d& origin)
{
  plane.moveBy (-origin);
  std::iota (plane.inliers.begin(), plane.inliers.end(), 0);
  return plane;
}

/** \brief Measures the convex hull of a plane.
 * \return hull relative to \p origin, area, length and width
 * \param[in] inliers points of the plane, relative to \p origin */
auto
extent (const PointRows& inliers,
        const Eigen::Vector3d& origin,
        const PlaneSegment& plane)
{
  const PlaneExtent found =
      planeExtent (viewOf (inliers), inCloudOfInliers (plane, origin));
  return std::make_tuple (found.hull, found.area, found.length, found.width);
}

/** \brief Finds the concave outline of a plane.
 * \return outline and holes relative to \p origin, and the area between them
 * \param[in] inliers points of the plane, relative to \p origin
 * \param[in] alpha radius of the alpha shape to begin with; 0: it follows the spacing
 * of the points */
auto
concaveExtent (const PointRows& inliers,
               const Eigen::Vector3d& origin,
               const PlaneSegment& plane,
               double alpha)
{
  const PlaneExtent found =
      concavePlaneExtent (viewOf (inliers), inCloudOfInliers (plane, origin), alpha);
  return std::make_pair (found.rings(), found.area);
}

/** \brief Merges planes.
 * \return merged planes, and for each given plane the position of its merged plane, or
 * no_plane */
std::pair<PlaneSegments, Labels>
merge (const PlaneSegments& planes, const MergePlanesParameters& parameters)
{
  std::vector<Moments> moments;
  for (const PlaneSegment& plane : planes)
    moments.push_back (plane.moments);
  const MergedPlanes merged = mergePlanes (moments, parameters.merging);
  PlaneSegments merged_planes;
  for (std::size_t i = 0; i < merged.fits.size(); ++i) {
    const auto& [plane, centroid, variances] = merged.fits[i];
    merged_planes.push_back (
        {centroid, plane.normal, {}, merged.moments[i].about (centroid), {}});
  }
  std::vector<double> most_points (merged_planes.size());
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (merged.merged_into[i] == no_plane)
      continue;
    const std::size_t into = merged.merged_into[i];
    PlaneSegment& merged_plane = merged_planes[into];
    // The merged plane has the side and the noise of its largest part.
    if (planes[i].moments.count > most_points[into]) {
      most_points[into] = planes[i].moments.count;
      merged_plane.noise = planes[i].noise;
      if (planes[i].normal.dot (merged_plane.normal) < 0.0)
        merged_plane.normal = -merged_plane.normal;
    }
    merged_plane.inliers.insert (
        merged_plane.inliers.end(), planes[i].inliers.begin(), planes[i].inliers.end());
  }
  for (PlaneSegment& merged_plane : merged_planes)
    std::sort (merged_plane.inliers.begin(), merged_plane.inliers.end());
  nameOrientations (
      merged_planes, parameters.up_axis.cast<double>(), parameters.angle_tolerance);
  return {std::move (merged_planes), merged.merged_into};
}

/** \brief A dict of Python.
 * \param[in] values pairs of name and value */
template <typename NamedValues>
py::dict
dictOf (const NamedValues& values)
{
  py::dict by_name;
  for (const auto& [name, value] : values)
    by_name[py::str (name)] = value;
  return by_name;
}

/** \brief Filters planes.
 * \return positions of the kept planes, and a dict of the number of planes that each
 * argument dropped */
py::tuple
filter (const py::list& planes, const PlaneFilter& filter)
{
  const auto segments = planes.cast<PlaneSegments>();
  const auto extent_of = [&] (const PlaneSegment& segment) {
    // keptPlanes calls this with elements of segments: the address tells the position
    // of the Python Plane, which has measured its hull.
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
  const std::pair<const char*, std::size_t> by_name[] = {
      {"orientation", dropped.by_orientation},
      {"direction", dropped.by_direction},
      {"slope", dropped.by_slope},
      {"min_points", dropped.by_points},
      {"min_area", dropped.by_area},
      {"min_width", dropped.by_width},
      {"max_area", dropped.by_max_area},
      {"max_width", dropped.by_max_width},
      {"size", dropped.by_size},
      {"max_planes", dropped.by_number}};
  return py::make_tuple (kept, dictOf (by_name));
}

/** \brief Finds kinds of planes by the hulls of Python's Planes, in the same frame.
 * \return the name of each plane's kind */
std::vector<std::string>
kinds (const py::list& planes,
       const Eigen::Vector3d& up,
       double meter,
       const std::optional<Eigen::Vector3d>& viewpoint)
{
  const auto segments = planes.cast<PlaneSegments>();
  std::vector<PlaneExtent> extents;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const PlaneFrame frame (segments[i].centroid, segments[i].normal);
    const auto corners =
        planes[i].attr ("hull").cast<Eigen::Matrix<double, Eigen::Dynamic, 3>>();
    PlanarPoints hull;
    for (Eigen::Index corner = 0; corner < corners.rows(); ++corner)
      hull.push_back (frame.toPlane (corners.row (corner).transpose()));
    // A plane without area has no hull: its centroid stands for its points.
    const PlanarPoints points = hull.empty() ? PlanarPoints{{0.0, 0.0}} : hull;
    extents.push_back (extentOf ({hull}, points, frame));
  }
  std::vector<std::string> names;
  for (const PlaneKind kind : planeKinds (segments, extents, up, meter, viewpoint))
    names.emplace_back (toString (kind));
  return names;
}

/** \brief Makes planes parallel, orthogonal and coplanar.
 * \return the planes, and how each moved: (angle, offset, displacement, is_moved,
 * direction, level) */
std::pair<PlaneSegments, py::list>
regularize (const PlaneSegments& planes,
            const PlaneRegularizationParameters& parameters)
{
  RegularizedPlanes found = regularizePlanes (planes, parameters);
  py::list moves;
  for (const auto& [angle, offset, displacement, is_moved, direction, level] :
       found.moves)
    moves.append (
        py::make_tuple (angle, offset, displacement, is_moved, direction, level));
  return {std::move (found.planes), moves};
}

/** \brief Matches the planes of two frames.
 * \return for each current plane the position of its previous one, or no_plane; and the
 * corrected pose
 * \param[in] pose of the current frame in the previous one */
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

/** \brief Estimates the up axis.
 * \return (direction, confidence), or None */
py::object
upAxis (const PlaneSegments& planes,
        const Eigen::Vector3d& viewpoint,
        const UpAxisParameters& parameters)
{
  const std::optional<UpAxis> found = estimateUpAxis (planes, viewpoint, parameters);
  return found ? py::object (py::make_tuple (found->direction, found->confidence))
               : py::none();
}

/** \brief Finds edges and corners.
 * \return (planes, start, end, angle) of edges, (planes, position) of corners
 * \param[in] points relative to \p origin; the planes are in the frame of the array */
std::pair<py::list, py::list>
edges (const PointRows& points,
       const Eigen::Vector3d& origin,
       const PlaneSegments& planes,
       const PlaneEdgeParameters& parameters)
{
  const PlaneEdges found = findPlaneEdges (viewOf (points), planes, parameters, origin);
  std::pair<py::list, py::list> edges_and_corners;
  for (const auto& [of_planes, from, to, angle] : found.edges)
    edges_and_corners.first.append (py::make_tuple (of_planes, from, to, angle));
  for (const auto& [of_planes, position] : found.corners)
    edges_and_corners.second.append (py::make_tuple (of_planes, position));
  return edges_and_corners;
}

/** \brief The kind with a name that \ref kinds returns; Other for any other name. */
PlaneKind
kindCalled (const std::string& name)
{
  for (const PlaneKind kind : {PlaneKind::Floor,
                               PlaneKind::Ceiling,
                               PlaneKind::Wall,
                               PlaneKind::Slab,
                               PlaneKind::Roof,
                               PlaneKind::Ramp,
                               PlaneKind::Table})
    if (name == toString (kind))
      return kind;
  return PlaneKind::Other;
}

/** \brief Draws a floor plan.
 * \return walls (start, end, thickness, openings, planes), with openings (start, end,
 * sill, head, rooms, is_door); rooms (rings, area, enclosed, floor, ceiling, middle,
 * unseen, doors_to); and the heights of the floor and of the cut
 * \param[in] points relative to \p origin; the planes are in the frame of the array
 * \param[in] names kind of each plane, as \ref kinds returns it */
py::tuple
plan (const PointRows& points,
      const Eigen::Vector3d& origin,
      const PlaneSegments& planes,
      const std::vector<std::string>& names,
      const Eigen::Vector3d& up,
      const FloorPlanParameters& parameters)
{
  std::vector<PlaneKind> kinds;
  std::transform (names.begin(), names.end(), std::back_inserter (kinds), kindCalled);
  const FloorPlan found =
      findFloorPlan (viewOf (points), planes, kinds, up, parameters, origin);
  py::list walls;
  for (const PlanWall& wall : found.walls) {
    py::list openings;
    for (const PlanOpening& opening : wall.openings)
      openings.append (
          py::make_tuple (opening.from,
                          opening.to,
                          opening.sill,
                          opening.head,
                          py::make_tuple (opening.room_before, opening.room_behind),
                          opening.isDoor()));
    walls.append (
        py::make_tuple (wall.from, wall.to, wall.thickness, openings, wall.planes));
  }
  py::list rooms;
  for (std::size_t i = 0; i < found.rooms.size(); ++i) {
    const PlanRoom& room = found.rooms[i];
    rooms.append (py::make_tuple (room.rings,
                                  room.area,
                                  room.enclosed,
                                  room.floor,
                                  room.ceiling,
                                  room.middle,
                                  room.unseen,
                                  py::tuple (py::cast (found.roomsBehindDoorsOf (i)))));
  }
  return py::make_tuple (walls, rooms, found.floor, found.height);
}

/** \brief Defines ResultContext; its viewpoint is in the frame of the user's array. */
void
defineContext (py::module_& module)
{
  py::class_<ResultContext> (module, "ResultContext")
      .def (py::init ([] {
        ResultContext context;
        context.names = ParameterNames::Python;
        context.max_warnings = std::numeric_limits<std::size_t>::max();
        return context;
      }))
      .def_readwrite ("viewpoint", &ResultContext::viewpoint)
      .def_readwrite ("has_meter", &ResultContext::has_meter)
      .def_readwrite ("uses_kinds", &ResultContext::uses_kinds)
      .def_readwrite ("has_camera_poses", &ResultContext::has_camera_poses)
      .def_readwrite ("search", &ResultContext::search)
      .def ("set_unit",
            [] (ResultContext& context, const std::string& unit) {
              context.unit = unit == "degree" ? CoordinateUnit::Degree
                             : unit == "foot" ? CoordinateUnit::Foot
                                              : CoordinateUnit::Meter;
            })
      .def ("set_up",
            [] (ResultContext& context, const Eigen::Vector3d& up, bool is_known) {
              context.up = up;
              context.up_knowledge =
                  is_known ? UpKnowledge::Known : UpKnowledge::Assumed;
            })
      .def ("set_plan",
            [] (ResultContext& context,
                std::size_t walls,
                std::size_t wall_planes,
                bool has_floor) {
              // No filter drops any of these planes: as many are kept as found.
              context.plan = PlanCounts{walls, wall_planes, wall_planes, has_floor};
            });
}

/** \brief Finds what is doubtful about a result.
 * \return code and text of each warning, the most important first
 * \param[in] points relative to \p origin; \p planes and \p context are relative to
 * zero of the user's array */
std::vector<std::pair<std::string, std::string>>
warningsOn (const PointRows& points,
            const Eigen::Vector3d& origin,
            const PlaneSegments& planes,
            ResultContext context)
{
  context.shift = origin;
  if (context.viewpoint)
    *context.viewpoint -= origin;
  std::vector<std::pair<std::string, std::string>> all;
  whileOthersRun ([&] {
    for (ResultWarning& warning : resultWarnings (viewOf (points), planes, context))
      all.emplace_back (std::move (warning.code), std::move (warning.text));
  });
  return all;
}

/** \brief Defines Tracker, whose planes are (number, segment, last_seen, first_seen,
 * times_seen, hull, area, length, width). */
void
defineTracker (py::module_& module)
{
  py::class_<PlaneTracker> (module, "Tracker")
      .def (py::init<PlaneMatchingParameters,
                     std::optional<std::size_t>,
                     std::optional<double>>())
      .def (py::init<const PlaneTracker&>())
      .def ("track",
            [] (PlaneTracker& tracker,
                const PlaneSegments& planes,
                const Eigen::Matrix4d& pose) {
              return tracker.track (planes, Eigen::Isometry3d (pose));
            })
      .def_property_readonly (
          "planes",
          [] (const PlaneTracker& tracker) {
            py::list all;
            for (const auto& [number, plane, extent, first, last, times] :
                 tracker.planes())
              all.append (py::make_tuple (number,
                                          plane,
                                          last,
                                          first,
                                          times,
                                          extent.hull,
                                          extent.area,
                                          extent.length,
                                          extent.width));
            return all;
          })
      .def_property_readonly (
          "pose", [] (const PlaneTracker& tracker) { return tracker.pose().matrix(); });
}

using PlaneNumbers = py::array_t<std::uint32_t, py::array::c_style>;

/** \brief Compares a result with the truth. \return a dict of all metrics by name
 * \param[in] truth, result number of each point's plane from 1 on; 0 for no plane
 * \param[in] parameters only up axis and tolerance are used, by which planes are
 * horizontal or vertical */
py::dict
evaluate (const PlaneNumbers& truth,
          const PlaneNumbers& result,
          const PointRows& points,
          const PlaneDetectorParameters& parameters)
{
  evaluation::ClassParameters classes;
  classes.up = parameters.up_axis.cast<double>().stableNormalized();
  classes.tolerance = parameters.angle_tolerance;
  const CloudView view = viewOf (points);
  const auto labels_of = [] (const PlaneNumbers& numbers) {
    return evaluation::PlaneLabels (numbers.data(), numbers.data() + numbers.size());
  };
  evaluation::Metrics metrics;
  whileOthersRun ([&] {
    evaluation::XyzCloud cloud;
    cloud.reserve (view.size);
    for (std::size_t i = 0; i < view.size; ++i)
      cloud.emplace_back (view[i][0], view[i][1], view[i][2]);
    metrics = evaluation::compareLabels (
        cloud, labels_of (truth), labels_of (result), classes);
  });
  py::dict by_name = dictOf (metrics.named);
  by_name["points"] = metrics.points;
  by_name["truth_planes"] = metrics.truth_planes;
  by_name["result_planes"] = metrics.result_planes;
  return by_name;
}

using Ops = OrientedPointSamplingParameters;
using Fspf = FastSamplingPlaneFilteringParameters;
using Kht = KernelHoughTransformParameters;

/** \brief Defines the structs of parameters: each has the name of its method or of its
 * function in Python. */
void
defineAllParameters (py::module_& module)
{
  defineParameters<Ops> (module, "ops").def_static ("paper", &Ops::paper);
  defineParameters<Fspf> (module, "fspf").def_static ("paper", &Fspf::paper);
  defineParameters<Kht> (module, "kht").def_static ("paper", &Kht::paper);
  defineParameters<PlaneDetectorParameters> (module, "evaluate");
  defineParameters<MergePlanesParameters> (module, "merge_planes");
  defineParameters<PlaneFilter> (module, "filter_planes");
  defineParameters<PlaneMatchingParameters> (module, "match_planes");
  defineParameters<UpAxisParameters> (module, "estimate_up_axis");
  defineParameters<PlaneEdgeParameters> (module, "find_plane_edges");
  defineParameters<PlaneRegularizationParameters> (module, "regularize_planes");
  defineParameters<FloorPlanParameters> (module, "floor_plan");
}

} // namespace

} // namespace pcl_ops::python

PYBIND11_MODULE (_pcl_ops, module)
{
  using namespace pcl_ops;
  using namespace pcl_ops::python;
  module.attr ("__version__") = PCL_OPS_VERSION;
  defineAllParameters (module);
  defineSegment (module);
  defineTracker (module);
  defineContext (module);
  module.def ("segment", &segment<Ops>);
  module.def ("segment", &segment<Fspf>);
  module.def ("segment", &segment<Kht>);
  module.def ("pieces", &pieces);
  module.def ("extent", &extent);
  module.def ("concave_extent", &concaveExtent);
  module.def ("covariance",
              [] (const PointRows& inliers,
                  const Eigen::Vector3d& origin,
                  const PlaneSegment& plane) {
                return matrixOf (planeCovariance (viewOf (inliers),
                                                  inCloudOfInliers (plane, origin)));
              });
  module.def ("merge", &merge);
  module.def ("filter", &filter);
  module.def ("kinds", &kinds);
  module.def ("match", &match);
  module.def ("up_axis", &upAxis);
  module.def ("edges", &edges);
  module.def ("plan", &plan);
  module.def ("warnings", &warningsOn);
  module.def ("regularize", &regularize);
  module.def ("compare", &evaluate);
  module.def ("is_seen_from",
              [] (const PointRows& points, const Eigen::Vector3d& viewpoint) {
                return isSeenFrom (viewpoint, viewOf (points));
              });
}
