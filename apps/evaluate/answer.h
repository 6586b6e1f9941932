// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace pcl_ops::evaluation {

using Answer = nlohmann::ordered_json;

std::string
decimal (double number, int decimals);

/** Objects of the same keys in Markdown with aligned columns, to be read
 * in a terminal, too: - for null, four decimals for floating-point numbers.
 * \param[in] list one object at least */
std::string
tableOf (const std::string& title, const Answer& list);

/** Prints what a command found: as JSON, or as a line for each value and a table for
 * each list of objects. */
void
print (const Answer& answer, bool as_json);

} // namespace pcl_ops::evaluation
