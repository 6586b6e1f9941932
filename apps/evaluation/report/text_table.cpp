// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "text_table.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace pcl_ops::evaluation {

namespace {

void
printRow (std::ostream& stream,
          const std::vector<std::string>& cells,
          const std::vector<std::size_t>& widths)
{
  for (std::size_t column = 0; column < cells.size(); ++column)
    stream << "| " << (column == 0 ? std::left : std::right)
           << std::setw (static_cast<int> (widths[column])) << cells[column] << ' ';
  stream << "|\n";
}

} // namespace

std::ostream&
operator<< (std::ostream& stream, const TextTable& table)
{
  std::vector<std::size_t> widths;
  for (const std::string& cell : table.header)
    widths.push_back (std::max<std::size_t> (3, cell.size()));
  for (const std::vector<std::string>& row : table.rows)
    for (std::size_t column = 0; column < row.size(); ++column)
      widths[column] = std::max (widths[column], row[column].size());

  stream << "**" << table.title << "**\n\n";
  printRow (stream, table.header, widths);
  for (std::size_t column = 0; column < widths.size(); ++column)
    stream << '|' << (column == 0 ? ":" : "-") << std::string (widths[column], '-')
           << (column == 0 ? "-" : ":");
  stream << "|\n";
  for (const std::vector<std::string>& row : table.rows)
    printRow (stream, row, widths);
  return stream << '\n';
}

std::string
decimal (double number, int decimals)
{
  if (std::isnan (number))
    return "-";
  std::ostringstream text;
  text << std::fixed << std::setprecision (decimals) << number;
  return text.str();
}

std::string
percent (double fraction)
{
  return decimal (100.0 * fraction, 2);
}

} // namespace pcl_ops::evaluation
