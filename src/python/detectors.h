// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "parameter_table.h"
#include <pcl_ops/plane_detector.h>

#include <functional>
#include <string>

namespace pcl_ops::python {

/** \brief A detector with all its parameters decided. */
using Detect = std::function<Detection (const DetectorInput&)>;

/** \param[in] method "ops", "fspf" or "kht"
 * \param[in] preset "default" or "paper"
 * \param[in] parameters those that differ from the preset's
 * \throw py::value_error, py::type_error which name the argument at fault */
Detect
detectorOf (const py::object& method,
            const py::object& preset,
            const py::dict& parameters);

/** \brief The parameters of a preset, by name. */
py::dict
parametersOf (const py::object& method, const py::object& preset);

/** \brief What orientations are named by, of "up" and "angle_tolerance".
 * \throw as \ref detectorOf */
PlaneDetectorParameters
orientationParameters (const py::dict& parameters);

/** \brief Those of merging, for \ref mergePlanes alone.
 * \throw as \ref detectorOf */
MergingParameters
mergingParameters (const py::dict& parameters);

} // namespace pcl_ops::python
