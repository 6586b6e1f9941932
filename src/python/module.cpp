// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
// The compiled part of the package. What users call, with documentation and checks of
// arrays, is Python beside it.
#include "given_parameters.h"
#include "interpreter.h"
#include "plane_lists.h"
#include "point_rows.h"
#include <evaluation/metrics/metrics.h>
#include <pcl_ops/detect_planes.h>
#include <pcl_ops/plane_extent.h>
#include <pcl_ops/visibility.h>

#include <numeric>

namespace pcl_ops::python {

namespace {

/** \brief Numbers that Python reads where they are, for as long as their owner lives.
 */
py::array
inliersOf (const py::object& owner)
{
  const auto& inliers = owner.cast<const PlaneSegment&>().inliers;
  py::array array = py::array_t<pcl::index_t> (
      static_cast<py::ssize_t> (inliers.size()), inliers.data(), owner);
  array.attr ("setflags") (py::arg ("write") = false);
  return array;
}

/** \brief u and v as rows, as numpy has vectors. */
Eigen::Matrix<double, 2, 3>
axesOf (const PlaneSegment& plane)
{
  const PlaneFrame frame (plane.centroid, plane.normal);
  Eigen::Matrix<double, 2, 3> axes;
  axes.row (0) = frame.directionInSpace (Eigen::Vector2d::UnitX());
  axes.row (1) = frame.directionInSpace (Eigen::Vector2d::UnitY());
  return axes;
}

std::optional<Eigen::Matrix3d>
covarianceOf (const PlaneSegment& plane)
{
  const std::optional<PlaneCovariance> covariance = planeCovariance (plane);
  return covariance ? std::make_optional (covariance->matrix) : std::nullopt;
}

/** \brief All it consists of, for a pickle. */
py::tuple
stateOf (const py::object& self)
{
  const auto& plane = self.cast<const PlaneSegment&>();
  const Moments& moments = plane.moments;
  return py::make_tuple (plane.centroid,
                         plane.normal,
                         plane.orientation,
                         moments.origin,
                         moments.count,
                         moments.sum,
                         moments.products,
                         inliersOf (self));
}

PlaneSegment
fromState (const py::tuple& state)
{
  PlaneSegment plane;
  plane.centroid = state[0].cast<Eigen::Vector3d>();
  plane.normal = state[1].cast<Eigen::Vector3d>();
  plane.orientation = state[2].cast<Orientation>();
  plane.moments.origin = state[3].cast<Eigen::Vector3d>();
  plane.moments.count = state[4].cast<double>();
  plane.moments.sum = state[5].cast<Eigen::Vector3d>();
  plane.moments.products = state[6].cast<std::array<double, 6>>();
  const auto inliers = state[7].cast<py::array_t<pcl::index_t, py::array::c_style>>();
  plane.inliers.assign (inliers.data(), inliers.data() + inliers.size());
  return plane;
}

/** \brief The class Segment, what a Plane of Python is made of. */
void
defineSegment (py::module_& module)
{
  py::class_<PlaneSegment> (module, "Segment")
      .def (py::init (&fromState))
      .def_readonly ("normal", &PlaneSegment::normal)
      .def_readonly ("centroid", &PlaneSegment::centroid)
      .def_property_readonly ("rms", &PlaneSegment::rms)
      .def_readonly ("orientation", &PlaneSegment::orientation)
      .def_property_readonly ("inliers", &inliersOf)
      .def_property_readonly ("axes", &axesOf)
      .def_property_readonly ("covariance", &covarianceOf)
      .def_property_readonly ("state", &stateOf);
}

/** \brief Calls \p use with the preset of a method. */
template <typename Use>
auto
usePreset (const std::string& method, const std::string& preset, const Use& use)
{
  const auto useOf = [&] (const auto& by_default) {
    using Parameters = std::decay_t<decltype (by_default)>;
    return use (preset == "paper" ? Parameters::paper() : by_default);
  };
  if (method == "ops")
    return useOf (OrientedPointSamplingParameters());
  if (method == "fspf")
    return useOf (FastSamplingPlaneFilteringParameters());
  return useOf (KernelHoughTransformParameters());
}

/** \brief (name, default, annotation) of each parameter.
 * \param[in] of a function of the package, or a method */
py::list
parametersOf (const std::string& of, const std::string& preset)
{
  if (of == "merge_planes")
    return listOf (MergePlanesParameters());
  if (of == "filter_planes")
    return listOf (PlaneFilter());
  if (of == "match_planes")
    return listOf (PlaneMatchingParameters());
  if (of == "estimate_up_axis")
    return listOf (UpAxisParameters());
  if (of == "find_plane_edges")
    return listOf (PlaneEdgeParameters());
  if (of == "evaluate")
    return listOf (OrientationParameters());
  return usePreset (
      of, preset, [] (const auto& parameters) { return listOf (parameters); });
}

/** \brief The planes in the frame of the array.
 * \param[in] points relative to \p origin
 * \param[in] origin, viewpoint in the frame of the array */
std::vector<PlaneSegment>
segment (const PointRows& points,
         const Eigen::Vector3d& origin,
         const Eigen::Vector3d& viewpoint,
         const std::string& method,
         const std::string& preset,
         const py::dict& given)
{
  const CloudView view = viewOf (points);
  return usePreset (method, preset, [&] (const auto& by_default) {
    const auto parameters = withGiven (by_default, given);
    std::vector<PlaneSegment> planes;
    whileOthersRun (
        [&] { planes = detectPlanes (view, parameters, viewpoint - origin); });
    for (PlaneSegment& plane : planes)
      plane.moveBy (origin);
    return planes;
  });
}

/** \return hull, area, length and width
 * \param[in] inliers of the plane, relative to \p origin */
py::tuple
extent (const PointRows& inliers, const Eigen::Vector3d& origin, PlaneSegment plane)
{
  plane.centroid -= origin;
  std::iota (plane.inliers.begin(), plane.inliers.end(), 0);
  const PlaneExtent found = planeExtent (viewOf (inliers), plane);
  Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor> hull (found.hull.size(), 3);
  for (std::size_t i = 0; i < found.hull.size(); ++i)
    hull.row (static_cast<Eigen::Index> (i)) = found.hull[i] + origin;
  return py::make_tuple (hull, found.area, found.length, found.width);
}

bool
seenFrom (const PointRows& points, const Eigen::Vector3d& viewpoint)
{
  return isSeenFrom (viewpoint, viewOf (points));
}

apps::XyzCloud
cloudOf (const CloudView& view)
{
  apps::XyzCloud cloud;
  cloud.points.reserve (view.size);
  for (std::size_t i = 0; i < view.size; ++i)
    cloud.points.emplace_back (view[i][0], view[i][1], view[i][2]);
  cloud.width = static_cast<std::uint32_t> (view.size);
  cloud.height = 1;
  return cloud;
}

using PlaneNumbers = py::array_t<std::uint32_t, py::array::c_style>;

/** \brief All metrics by name.
 * \param[in] truth, result the plane of each point from 1, 0 for none */
py::dict
evaluate (const PlaneNumbers& truth,
          const PlaneNumbers& result,
          const PointRows& points,
          const py::dict& given)
{
  const auto named_by = withGiven (OrientationParameters(), given);
  evaluation::ClassParameters classes;
  classes.up = named_by.up_axis.cast<double>().stableNormalized();
  classes.tolerance = named_by.angle_tolerance;
  const CloudView view = viewOf (points);
  const auto labelsOf = [] (const PlaneNumbers& numbers) {
    return evaluation::PlaneLabels (numbers.data(), numbers.data() + numbers.size());
  };
  evaluation::Metrics metrics;
  whileOthersRun ([&] {
    metrics = evaluation::compareLabels (
        cloudOf (view), labelsOf (truth), labelsOf (result), classes);
  });
  py::dict named;
  for (const auto& [name, value] : evaluation::namedMetrics (metrics))
    named[py::str (name)] = value;
  named[evaluation::off_planes_name] = metrics.points_off_planes_called_planes;
  named["points"] = metrics.points;
  named["truth_planes"] = metrics.truth_planes;
  named["result_planes"] = metrics.result_planes;
  return named;
}

} // namespace

} // namespace pcl_ops::python

PYBIND11_MODULE (_pcl_ops, module)
{
  using namespace pcl_ops::python;
  module.attr ("__version__") = PCL_OPS_VERSION;
  defineSegment (module);
  defineListFunctions (module);
  module.def ("parameters", &parametersOf);
  module.def ("segment", &segment);
  module.def ("extent", &extent);
  module.def ("is_seen_from", &seenFrom);
  module.def ("evaluate", &evaluate);
}
