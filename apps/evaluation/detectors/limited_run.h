// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "detectors.h"

#include <optional>

namespace pcl_ops::evaluation {

/** \brief Runs a detector in a process of its own, which ends with it if it takes too
 * long.
 * \param[in] seconds of wall time; 0: as long as it takes
 * \return nothing if that was reached
 * \throw std::runtime_error if the detector fails, however it does */
std::optional<DetectorRun>
runLimited (const Configuration& configuration,
            const XyzCloud::ConstPtr& cloud,
            const RunSettings& settings,
            unsigned seconds);

} // namespace pcl_ops::evaluation
