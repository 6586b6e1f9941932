// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "detectors.h"

#include <optional>

namespace pcl_ops::evaluation {

/** \brief Does something in a process of its own.
 * \param[in] work gives the bytes that are handed over
 * \param[in] seconds of wall time, after which it is ended; 0: none
 * \return nothing if that was reached
 * \throw std::runtime_error if it fails, however it does */
std::optional<std::string>
runInChild (const std::function<std::string()>& work, unsigned seconds);

/** \brief Runs a detector, one of others in a process of its own.
 * \param[in] seconds, and errors, as of \ref runInChild
 * \return nothing if it takes longer */
std::optional<DetectorRun>
runLimited (const Configuration& configuration,
            const XyzCloud::ConstPtr& cloud,
            const RunSettings& settings,
            unsigned seconds);

} // namespace pcl_ops::evaluation
