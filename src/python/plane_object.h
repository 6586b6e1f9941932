// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/plane.h>
#include <pcl_ops/plane_extent.h>
#include <pybind11/numpy.h>

#include <optional>

namespace pcl_ops::python {

namespace py = pybind11;

/** \brief A plane as Python has it, in the frame of its array. */
struct PlaneObject {
  PlaneSegment segment;
  /** \brief What its inliers are rows of. */
  py::array points;
  /** \brief Found out when first asked for: it takes longer than finding the plane. */
  std::optional<PlaneExtent> known_extent;

  const PlaneExtent&
  extent ();
};

/** \brief The class pcl_ops.Plane. */
void
definePlane (py::module_& module);

} // namespace pcl_ops::python
