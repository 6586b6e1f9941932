// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan.h"
#include "plane_joining.h"

#include <string>

namespace pcl_ops::apps {

/** \brief The text of planes.json. */
std::string
toJson (const Plan& plan, std::size_t tiles, const std::vector<JoinedPlane>& planes);

} // namespace pcl_ops::apps
