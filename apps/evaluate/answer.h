// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace pcl_ops::evaluation {

/** What a command prints: an object whose values are numbers, texts, lists of numbers,
 * or lists of objects. */
using Answer = nlohmann::ordered_json;

/** Returns a number with a fixed number of decimals. */
std::string
decimal (double number, int decimals);

/** Returns a Markdown table with a row for each object and a column for each key.
 * Columns are padded, so that they are aligned in a terminal, too. Null and NaN are
 * "-"; other floating-point numbers have four decimals.
 * \param[in] list at least one object, all with the same keys */
std::string
tableOf (const std::string& title, const Answer& list);

/** Prints the result of a command, as JSON or as text: a table for each list of objects
 * and a line for each other value. */
void
print (const Answer& answer, bool as_json);

} // namespace pcl_ops::evaluation
