// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan.h"
#include "plane_sample.h"
#include <pcl_ops/result_warnings.h>

#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief Adds warnings to a list of planes, found in a sample of the labelled points.
 * \return the new text of the list; the same text if there are no warnings
 * \param[in] has_meter whether the user gave the length of a meter, even if it is 1
 * \throws WorkError as \p points does */
std::string
withWarnings (const Plan& plan,
              bool has_meter,
              const std::string& list_text,
              const LabelledPoints& points);

/** \brief The warnings that \ref withWarnings has added to a list. */
std::vector<ResultWarning>
warningsIn (const nlohmann::ordered_json& list);

} // namespace pcl_ops::apps
