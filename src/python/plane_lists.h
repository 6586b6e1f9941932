// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plane_object.h"

namespace pcl_ops::python {

/** \brief The planes after merging, and into which of them each of \p planes went, -1
 * where it was dropped.
 * \param[in] planes of one array
 * \param[in] orientation what orientations are named by, see \ref orientationParameters
 * \param[in] merging see \ref mergingParameters
 * \throw py::value_error, py::type_error which name the argument at fault */
py::tuple
mergedPlanes (const py::list& planes,
              const py::dict& orientation,
              const py::dict& merging);

/** \brief Direction and confidence, or None.
 * \throw as \ref mergedPlanes */
py::object
upAxisOf (const py::list& planes,
          const py::object& viewpoint,
          const py::dict& parameters);

/** \brief The planes that are kept, and how many were dropped by what.
 * \throw as \ref mergedPlanes */
py::tuple
filteredPlanes (const py::list& planes, const py::dict& filter);

/** \brief For each of \p current the position in \p previous, -1 for none; and the pose
 * as mended.
 * \throw as \ref mergedPlanes */
py::tuple
matchedPlanes (const py::list& previous,
               const py::list& current,
               const py::object& pose,
               const py::dict& parameters);

} // namespace pcl_ops::python
