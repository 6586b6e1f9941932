// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan.h"
#include "plane_sample.h"
#include <pcl_ops/result_warnings.h>

#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief Adds warnings about the planes of a survey to the list of planes. They follow
 * from the labeled points, which are visited twice, from the tiles of the plan and, if
 * the first input is a .las or .laz, from its reference system.
 * \return the new text of the list; the same text if there are no warnings
 * \param[in] has_meter whether the user gave the length of a meter, even if it is 1
 * \param[in] list_text JSON of the list
 * \throws WorkError as \p for_each_point does, or if the first input cannot be read */
std::string
withWarnings (const Plan& plan,
              bool has_meter,
              const std::string& list_text,
              const ForEachLabeledPoint& for_each_point);

/** \brief Returns the warnings that \ref withWarnings has added to a list; none if it
 * has added none. */
std::vector<ResultWarning>
warningsIn (const nlohmann::ordered_json& list);

} // namespace pcl_ops::apps
