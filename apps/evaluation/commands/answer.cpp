// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "answer.h"

#include <evaluation/report/text_table.h>

#include <iomanip>
#include <iostream>

namespace pcl_ops::evaluation {

namespace {

std::string
cellOf (const Answer& value)
{
  constexpr int decimals = 4;
  const std::string text = value.dump(); // of NaN, too, null
  return text == "null"            ? "-"
         : value.is_number_float() ? decimal (value, decimals)
         : value.is_string()       ? value.get<std::string>()
                                   : text;
}

void
printTable (const std::string& title, const Answer& list)
{
  TextTable table{title, {}, {}};
  for (const Answer& object : list) {
    table.header.clear();
    table.rows.emplace_back();
    for (const auto& [name, value] : object.items()) {
      table.header.push_back (name);
      table.rows.back().push_back (cellOf (value));
    }
  }
  std::cout << '\n' << table;
}

} // namespace

void
print (const Answer& answer, bool as_json)
{
  constexpr int width_of_names = 34;
  if (as_json) {
    std::cout << answer.dump (2) << '\n';
    return;
  }
  for (const auto& [name, value] : answer.items())
    if (value.is_array() && !value.empty() && value[0].is_object())
      printTable (name, value);
    else
      std::cout << std::left << std::setw (width_of_names) << name << cellOf (value)
                << '\n';
}

} // namespace pcl_ops::evaluation
