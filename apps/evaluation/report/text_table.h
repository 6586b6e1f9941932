// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace pcl_ops::evaluation {

struct TextTable {
  std::string title;
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
};

/** \brief Prints Markdown with aligned columns, so that it reads as well in a terminal.
 */
std::ostream&
operator<< (std::ostream& stream, const TextTable& table);

/** \brief A number with a fixed number of decimals. */
std::string
decimal (double number, int decimals);

} // namespace pcl_ops::evaluation
