// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "interpreter.h"
#include <pcl_ops/cloud_view.h>
#include <pcl_ops/plane_detector_parameters.h>
#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

namespace pcl_ops::python {

namespace py = pybind11;

/** \brief Those of merging, and which of the merged planes are horizontal. */
struct MergePlanesParameters : PlaneDetectorParameters {};

/** \brief The structs of parameters of all functions. */
void
defineParameters (py::module_& module);

/** \brief What is done with lists of planes: merging, filtering, matching, tracking,
 * their edges, and which way is up. */
void
defineListFunctions (py::module_& module);

/** \brief Points as the package's own Python code hands them over: aligned, of shape
 * (N, 3), the numbers of a row side by side and rows in order. */
using PointRows = py::array_t<float>;

/** \brief The points where they are. */
inline CloudView
viewOf (const PointRows& points)
{
  CloudView view;
  view.first = points.data();
  view.stride = static_cast<std::size_t> (points.strides (0)) / sizeof (float);
  view.size = static_cast<std::size_t> (points.shape (0));
  return view;
}

} // namespace pcl_ops::python
