// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "answer.h"

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <sstream>

namespace pcl_ops::evaluation {

namespace {

std::string
cellOf (const Answer& value)
{
  const std::string text = value.dump(); // NaN becomes null, too
  return text == "null"            ? "-"
         : value.is_number_float() ? decimal (value, 4)
         : value.is_string()       ? value.get<std::string>()
                                   : text;
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
  std::string header;
  std::string rule;
  std::vector<std::string> rows (list.size());
  for (const auto& [name, ignored] : list[0].items()) {
    std::size_t width = std::max<std::size_t> (3, name.size()); // Markdown needs 3
    for (const Answer& object : list)
      width = std::max (width, cellOf (object[name]).size());
    const bool is_first = header.empty();
    const auto padded = [&] (const std::string& cell) {
      const std::string gap (width - cell.size(), ' ');
      return "| " + (is_first ? cell + gap : gap + cell) + " ";
    };
    header += padded (name);
    rule +=
        (is_first ? "|:" : "|-") + std::string (width, '-') + (is_first ? "-" : ":");
    for (std::size_t i = 0; i < rows.size(); ++i)
      rows[i] += padded (cellOf (list[i][name]));
  }
  std::string table = "**" + title + "**\n\n" + header + "|\n" + rule + "|\n";
  for (const std::string& row : rows)
    table += row + "|\n";
  return table + "\n";
}

void
print (const Answer& answer, bool as_json)
{
  constexpr int width_of_names = 34;
  if (as_json)
    std::cout << answer.dump (2) << '\n';
  else
    for (const auto& [name, value] : answer.items())
      if (value.is_array() && !value.empty() && value[0].is_object())
        std::cout << '\n' << tableOf (name, value);
      else
        std::cout << std::left << std::setw (width_of_names) << name << cellOf (value)
                  << '\n';
}

} // namespace pcl_ops::evaluation
