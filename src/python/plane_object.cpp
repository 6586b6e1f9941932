// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "plane_object.h"

#include "point_array.h"
#include <pybind11/eigen.h>

#include <numeric>

namespace pcl_ops::python {

namespace {

/** \brief Numbers that Python reads where they are, for as long as their owner lives.
 */
py::array
inliersOf (const py::object& owner)
{
  const auto& inliers = owner.cast<const PlaneObject&>().segment.inliers;
  py::array array = py::array_t<pcl::index_t> (
      static_cast<py::ssize_t> (inliers.size()), inliers.data(), owner);
  array.attr ("setflags") (py::arg ("write") = false);
  return array;
}

Eigen::Vector4d
coefficientsOf (const PlaneObject& plane)
{
  const Plane equation = plane.segment.plane();
  return {
      equation.normal.x(), equation.normal.y(), equation.normal.z(), equation.offset};
}

Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>
hullOf (PlaneObject& plane)
{
  const std::vector<Eigen::Vector3d>& hull = plane.extent().hull;
  Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor> corners (hull.size(), 3);
  for (std::size_t i = 0; i < hull.size(); ++i)
    corners.row (static_cast<Eigen::Index> (i)) = hull[i];
  return corners;
}

py::object
covarianceOf (const PlaneObject& plane)
{
  const std::optional<PlaneCovariance> covariance = planeCovariance (plane.segment);
  return covariance ? py::cast (covariance->matrix) : py::none();
}

/** \brief u and v as rows, as numpy has vectors. */
Eigen::Matrix<double, 2, 3>
axesOf (const PlaneObject& plane)
{
  const PlaneFrame frame (plane.segment.centroid, plane.segment.normal);
  Eigen::Matrix<double, 2, 3> axes;
  axes.row (0) = frame.directionInSpace (Eigen::Vector2d::UnitX());
  axes.row (1) = frame.directionInSpace (Eigen::Vector2d::UnitY());
  return axes;
}

double
rmsOf (const PlaneObject& plane)
{
  return plane.segment.rms();
}

std::string
orientationOf (const PlaneObject& plane)
{
  return toString (plane.segment.orientation);
}

std::string
textOf (const PlaneObject& plane)
{
  const auto text = py::str ("<pcl_ops.Plane: {}, {} points, rms {:.3g}>");
  return text.format (
      orientationOf (plane), plane.segment.inliers.size(), rmsOf (plane));
}

using PlaneClass = py::class_<PlaneObject>;

void
defineFit (PlaneClass& plane)
{
  const auto get = [] (auto member) {
    return [member] (const PlaneObject& object) { return object.segment.*member; };
  };
  plane
      .def_property_readonly ("normal",
                              get (&PlaneSegment::normal),
                              "(3,) float64: unit normal, towards the viewpoint.")
      .def_property_readonly ("centroid",
                              get (&PlaneSegment::centroid),
                              "(3,) float64: mean of the inliers, on the plane.")
      .def_property_readonly ("coefficients",
                              &coefficientsOf,
                              "(4,) float64: normal and d of a x + b y + c z + d = 0.")
      .def_property_readonly (
          "rms", &rmsOf, "Root mean square distance of the inliers to the plane.")
      .def_property_readonly (
          "orientation", &orientationOf, "'horizontal', 'vertical' or 'other'.")
      .def_property_readonly (
          "inliers",
          &inliersOf,
          "(n,) int32, read-only: rows of the array that are on the plane, ascending.");
}

void
defineExtent (PlaneClass& plane)
{
  const auto get = [] (auto member) {
    return [member] (PlaneObject& object) { return object.extent().*member; };
  };
  plane
      .def_property_readonly ("hull",
                              &hullOf,
                              "(m, 3) float64: corners of the convex outline, on the "
                              "plane, counter-clockwise\nseen from the side the normal "
                              "points to, the first not repeated.")
      .def_property_readonly ("area", get (&PlaneExtent::area), "Area of the hull.")
      .def_property_readonly ("length",
                              get (&PlaneExtent::length),
                              "Longer side of the smallest rectangle around the hull.")
      .def_property_readonly (
          "width", get (&PlaneExtent::width), "Shorter side of that rectangle.");
}

void
defineCovariance (PlaneClass& plane)
{
  plane
      .def_property_readonly (
          "axes",
          &axesOf,
          "(2, 3) float64: unit vectors u and v in the plane, u x v "
          "= normal, those of\ncovariance. They depend on the "
          "normal alone.")
      .def_property_readonly (
          "covariance",
          &covarianceOf,
          "(3, 3) float64: covariance of the errors of (tilt along u [rad], tilt along "
          "v\n[rad], offset). With errors (a, b, c) the surface has the height c + a s "
          "+ "
          "b t\nover the plane at centroid + s u + t v. Right for noise that is "
          "independent from\npoint to point. None for fewer than four inliers.");
}

} // namespace

const PlaneExtent&
PlaneObject::extent()
{
  if (known_extent)
    return *known_extent;
  const auto count = static_cast<py::ssize_t> (segment.inliers.size());
  const py::array_t<pcl::index_t> rows (count, segment.inliers.data());
  const PointArray on_plane (points.attr ("take") (rows, py::arg ("axis") = 0));
  PlaneSegment among_them = segment;
  among_them.centroid -= on_plane.origin();
  std::iota (among_them.inliers.begin(), among_them.inliers.end(), 0);
  PlaneExtent found = planeExtent (on_plane.view(), among_them);
  for (Eigen::Vector3d& corner : found.hull)
    corner += on_plane.origin();
  found.center += on_plane.origin();
  return known_extent.emplace (std::move (found));
}

void
definePlane (py::module_& module)
{
  PlaneClass plane (
      module,
      "Plane",
      "A plane and the points on it, in the frame and the unit of their array. Hull, "
      "area,\nlength and width are found out when first asked for, from the array as "
      "it is then;\nof one in another order of bytes from its copy.");
  defineFit (plane);
  defineExtent (plane);
  defineCovariance (plane);
  plane.def ("__repr__", &textOf);
  // Else protocols 0 and 1 of pickle end the program in pybind11.
  plane.def ("__reduce_ex__", [] (const PlaneObject&, int /*protocol*/) -> py::object {
    throw py::type_error ("cannot pickle or copy 'pcl_ops.Plane' objects");
  });
  plane.attr ("__module__") = "pcl_ops";
}

} // namespace pcl_ops::python
