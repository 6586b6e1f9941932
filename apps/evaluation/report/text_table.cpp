// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "text_table.h"

#include <algorithm>
#include <iomanip>
#include <ostream>
#include <sstream>

namespace pcl_ops::evaluation {

std::ostream&
operator<< (std::ostream& stream, const TextTable& table)
{
  std::vector<std::size_t> widths (table.header.size(), 3); // the least in Markdown
  const auto widen = [&] (const std::vector<std::string>& cells) {
    for (std::size_t column = 0; column < cells.size(); ++column)
      widths[column] = std::max (widths[column], cells[column].size());
  };
  const auto print = [&] (const std::vector<std::string>& cells) {
    for (std::size_t column = 0; column < cells.size(); ++column)
      stream << "| " << (column == 0 ? std::left : std::right)
             << std::setw (static_cast<int> (widths[column])) << cells[column] << ' ';
    stream << "|\n";
  };
  widen (table.header);
  std::for_each (table.rows.begin(), table.rows.end(), widen);

  stream << "**" << table.title << "**\n\n";
  print (table.header);
  for (std::size_t column = 0; column < widths.size(); ++column)
    stream << '|' << (column == 0 ? ":" : "-") << std::string (widths[column], '-')
           << (column == 0 ? "-" : ":");
  stream << "|\n";
  std::for_each (table.rows.begin(), table.rows.end(), print);
  return stream << std::endl;
}

std::string
decimal (double number, int decimals)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision (decimals) << number;
  return text.str();
}

} // namespace pcl_ops::evaluation
