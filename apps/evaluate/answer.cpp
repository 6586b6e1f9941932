// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "answer.h"

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <sstream>

namespace pcl_ops::evaluation {

namespace {

/** Returns a value as text for a table or a line. */
std::string
cellOf (const Answer& value)
{
  constexpr int decimals = 4;
  const std::string text = value.dump();
  if (text == "null") // also NaN
    return "-";
  if (value.is_number_float())
    return decimal (value, decimals);
  return value.is_string() ? value.get<std::string>() : text;
}

} // namespace

std::string
decimal (double number, int decimals)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision (decimals) << number;
  return text.str();
}

std::string
tableOf (const std::string& title, const Answer& list)
{
  constexpr std::size_t min_width = 3; // what some readers of Markdown ask for
  std::string header;
  std::string delimiter_row; // below the header, with a colon on the aligned side
  std::vector<std::string> rows (list.size());
  for (const auto& [name, ignored] : list[0].items()) {
    std::size_t width = std::max (min_width, name.size());
    for (const Answer& object : list)
      width = std::max (width, cellOf (object[name]).size());
    const bool is_first = header.empty(); // aligned left; other columns right
    const auto padded = [&] (const std::string& cell) {
      const std::string gap (width - cell.size(), ' ');
      return "| " + (is_first ? cell + gap : gap + cell) + " ";
    };
    header += padded (name);
    delimiter_row +=
        (is_first ? "|:" : "|-") + std::string (width, '-') + (is_first ? "-" : ":");
    for (std::size_t i = 0; i < rows.size(); ++i)
      rows[i] += padded (cellOf (list[i][name]));
  }
  std::string table = "**" + title + "**\n\n" + header + "|\n" + delimiter_row + "|\n";
  for (const std::string& row : rows)
    table += row + "|\n";
  return table + "\n";
}

void
print (const Answer& answer, bool as_json)
{
  constexpr int indent = 2;
  constexpr int width_of_names = 34; // more than the longest name has
  if (as_json)
    std::cout << answer.dump (indent) << '\n';
  else
    for (const auto& [name, value] : answer.items())
      if (value.is_array() && !value.empty() && value[0].is_object())
        std::cout << '\n' << tableOf (name, value);
      else
        std::cout << std::left << std::setw (width_of_names) << name << cellOf (value)
                  << '\n';
}

} // namespace pcl_ops::evaluation
