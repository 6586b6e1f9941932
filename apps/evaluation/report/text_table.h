// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace pcl_ops::evaluation {

/** \brief A table of texts. */
struct TextTable {
  std::string title;
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
};

/** \brief Prints a table in Markdown with its columns aligned, so that it reads as well
 * in a terminal. */
std::ostream&
operator<< (std::ostream& stream, const TextTable& table);

/** \brief A number with a fixed number of decimals; "-" for NaN. */
std::string
decimal (double number, int decimals);

/** \brief A fraction as per cent with two decimals; "-" for NaN. */
std::string
percent (double fraction);

} // namespace pcl_ops::evaluation
