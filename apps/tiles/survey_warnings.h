// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan.h"
#include "plane_sample.h"
#include <pcl_ops/result_warnings.h>

#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief A list of planes with what is doubtful about them, by some labelled points;
 * the same text where nothing is.
 * \param[in] has_meter whether the length of a meter was given, 1 or not
 * \throws WorkError as \p points does */
std::string
withWarnings (const Plan& plan,
              bool has_meter,
              const std::string& list_text,
              const LabelledPoints& points);

/** \brief Those that \ref withWarnings put into a list. */
std::vector<ResultWarning>
warningsIn (const nlohmann::ordered_json& list);

} // namespace pcl_ops::apps
