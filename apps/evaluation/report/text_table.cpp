// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "text_table.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <ostream>
#include <sstream>
#include <utility>

namespace pcl_ops::evaluation {

std::ostream&
operator<< (std::ostream& stream, const TextTable& table)
{
  std::vector<std::size_t> widths (table.header.size(), 0);
  for (const std::vector<std::string>& row : table.rows)
    for (std::size_t column = 0; column < row.size(); ++column)
      widths[column] = std::max (widths[column], row[column].size());
  GrowingTable lines (stream, table.title, table.header, widths);
  for (const std::vector<std::string>& row : table.rows)
    lines.add (row);
  lines.end();
  return stream;
}

GrowingTable::GrowingTable (std::ostream& stream,
                            const std::string& title,
                            const std::vector<std::string>& header,
                            std::vector<std::size_t> widths)
: stream_ (stream), widths_ (std::move (widths))
{
  constexpr std::size_t narrowest = 3; // in Markdown
  widths_.resize (header.size(), 0);
  for (std::size_t column = 0; column < header.size(); ++column)
    widths_[column] = std::max ({widths_[column], header[column].size(), narrowest});
  stream_ << "**" << title << "**\n\n";
  print (header);
  for (std::size_t column = 0; column < widths_.size(); ++column)
    stream_ << '|' << (column == 0 ? ":" : "-") << std::string (widths_[column], '-')
            << (column == 0 ? "-" : ":");
  stream_ << '|' << std::endl;
}

void
GrowingTable::add (const std::vector<std::string>& row)
{
  print (row);
  stream_ << std::flush;
}

void
GrowingTable::end()
{
  stream_ << std::endl;
}

void
GrowingTable::print (const std::vector<std::string>& cells)
{
  for (std::size_t column = 0; column < cells.size(); ++column)
    stream_ << "| " << (column == 0 ? std::left : std::right)
            << std::setw (static_cast<int> (widths_[column])) << cells[column] << ' ';
  stream_ << "|\n";
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
