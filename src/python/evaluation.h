// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/numpy.h>

namespace pcl_ops::python {

namespace py = pybind11;

/** \brief All metrics of two labellings of points, by name.
 * \param[in] truth, result planes of the points, any negative number for none
 * \param[in] points as PointArray has them
 * \param[in] orientation what classes are told by, see \ref orientationParameters
 * \throw py::value_error, py::type_error which name the argument at fault */
py::dict
evaluate (const py::array& truth,
          const py::array& result,
          const py::array& points,
          const py::dict& orientation);

} // namespace pcl_ops::python
