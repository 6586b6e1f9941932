// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "warnings/parameter_text.h"
#include <pcl_ops/plane.h>
#include <pcl_ops/result_warnings.h>

#include <optional>
#include <vector>

namespace pcl_ops::internal {

/** \brief That much is on planes whose rms is several times the noise around them. */
std::optional<ResultWarning>
warnOfThickPlanes (const std::vector<PlaneSegment>& planes, const ParameterText& text);

} // namespace pcl_ops::internal
