// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plane_object.h"

namespace pcl_ops::python {

/** \brief Labels of the points, and the planes.
 * \param[in] points as \ref PointArray has them
 * \param[in] viewpoint where the sensor was, in the frame of the array
 * \throw py::value_error, py::type_error which name the argument at fault */
py::tuple
segment (const py::array& points,
         const py::object& method,
         const py::object& preset,
         const py::object& viewpoint,
         const py::dict& parameters);

} // namespace pcl_ops::python
