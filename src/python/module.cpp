// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
// The compiled part of the package. What users call, with documentation and checks of
// arrays, is Python beside it.
#include "module.h"

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
matrixOf (const std::optional<PlaneCovariance>& covariance)
{
  return covariance ? std::make_optional (covariance->matrix) : std::nullopt;
}

std::optional<Eigen::Matrix3d>
covarianceOf (const PlaneSegment& plane)
{
  return matrixOf (planeCovariance (plane));
}

/** \brief What a plane consists of besides orientation and inliers: centroid, normal,
 * and of the moments origin, count, sum and products. */
using Numbers = Eigen::Matrix<double, 19, 1>;

/** \brief All that it consists of, for a pickle. */
py::tuple
stateOf (const py::object& self)
{
  const auto& plane = self.cast<const PlaneSegment&>();
  const auto& [origin, count, sum, products] = plane.moments;
  const Eigen::Map<const Eigen::Matrix<double, 6, 1>> six (products.data());
  Numbers numbers;
  numbers << plane.centroid, plane.normal, origin, count, sum, six;
  return py::make_tuple (
      numbers, static_cast<int> (plane.orientation), inliersOf (self));
}

PlaneSegment
fromState (const std::tuple<Numbers, int, py::array_t<pcl::index_t>>& state)
{
  const auto& [numbers, orientation, inliers] = state;
  PlaneSegment plane;
  auto& [origin, count, sum, products] = plane.moments;
  plane.centroid = numbers.segment<3> (0);
  plane.normal = numbers.segment<3> (3);
  plane.orientation = static_cast<Orientation> (orientation);
  origin = numbers.segment<3> (6);
  count = numbers[9];
  sum = numbers.segment<3> (10);
  std::copy (numbers.data() + 13, numbers.data() + 19, products.begin());
  plane.inliers.assign (inliers.data(), inliers.data() + inliers.size());
  return plane;
}

/** \brief The class Segment, base of Python's Plane, which takes what is in the one it
 * is made of. */
void
defineSegment (py::module_& module)
{
  py::class_<PlaneSegment> (module, "Segment")
      .def (py::init ([] (PlaneSegment& taken) { return std::move (taken); }))
      .def (py::init (&fromState))
      .def_readonly ("normal", &PlaneSegment::normal)
      .def_readonly ("centroid", &PlaneSegment::centroid)
      .def_property_readonly ("rms", &PlaneSegment::rms)
      .def_readonly ("orientation", &PlaneSegment::orientation)
      .def_property_readonly ("inliers", &inliersOf)
      .def_property_readonly ("axes", &axesOf)
      .def_property_readonly ("covariance", &covarianceOf)
      .def_property_readonly ("_state", &stateOf);
}

/** \brief The planes in the frame of the array.
 * \param[in] points relative to \p origin
 * \param[in] origin, viewpoint in the frame of the array */
template <typename Parameters>
std::vector<PlaneSegment>
segment (const PointRows& points,
         const Eigen::Vector3d& origin,
         const Eigen::Vector3d& viewpoint,
         const Parameters& parameters)
{
  const CloudView view = viewOf (points);
  std::vector<PlaneSegment> planes;
  whileOthersRun (
      [&] { planes = detectPlanes (view, parameters, viewpoint - origin); });
  for (PlaneSegment& plane : planes)
    plane.moveBy (origin);
  return planes;
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

/** \brief Of noise that neighboring points share.
 * \param[in] inliers of the plane, relative to \p origin */
std::optional<Eigen::Matrix3d>
correlatedCovariance (const PointRows& inliers,
                      const Eigen::Vector3d& origin,
                      PlaneSegment plane)
{
  plane.moveBy (-origin);
  std::iota (plane.inliers.begin(), plane.inliers.end(), 0);
  return matrixOf (planeCovariance (viewOf (inliers), plane));
}

using PlaneNumbers = py::array_t<std::uint32_t, py::array::c_style>;

/** \brief All metrics by name.
 * \param[in] truth, result the plane of each point from 1, 0 for none */
py::dict
evaluate (const PlaneNumbers& truth,
          const PlaneNumbers& result,
          const PointRows& points,
          const PlaneDetectorParameters& named_by)
{
  evaluation::ClassParameters classes;
  classes.up = named_by.up_axis.cast<double>().stableNormalized();
  classes.tolerance = named_by.angle_tolerance;
  const CloudView view = viewOf (points);
  const auto labelsOf = [] (const PlaneNumbers& numbers) {
    return evaluation::PlaneLabels (numbers.data(), numbers.data() + numbers.size());
  };
  evaluation::Metrics metrics;
  whileOthersRun ([&] {
    apps::XyzCloud cloud;
    cloud.reserve (view.size);
    for (std::size_t i = 0; i < view.size; ++i)
      cloud.emplace_back (view[i][0], view[i][1], view[i][2]);
    metrics =
        evaluation::compareLabels (cloud, labelsOf (truth), labelsOf (result), classes);
  });
  py::dict named;
  for (const auto& [name, value] : metrics.named)
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
  defineParameters (module);
  defineSegment (module);
  defineListFunctions (module);
  module.def ("segment", &segment<pcl_ops::OrientedPointSamplingParameters>);
  module.def ("segment", &segment<pcl_ops::FastSamplingPlaneFilteringParameters>);
  module.def ("segment", &segment<pcl_ops::KernelHoughTransformParameters>);
  module.def ("extent", &extent);
  module.def ("correlated_covariance", &correlatedCovariance);
  module.def ("is_seen_from",
              [] (const PointRows& points, const Eigen::Vector3d& viewpoint) {
                return pcl_ops::isSeenFrom (viewpoint, viewOf (points));
              });
  module.def ("compare", &evaluate);
}
