// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>

namespace pcl_ops::evaluation {

using Answer = nlohmann::ordered_json;

/** \brief Prints what a command found: as JSON, or as a line for each value and a table
 * for each list of objects. */
void
print (const Answer& answer, bool as_json);

} // namespace pcl_ops::evaluation
