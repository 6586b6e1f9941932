// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
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

/** \brief The same for rows that come one by one: each is printed at once, also
 * to a file, so that a long run can be watched. */
class GrowingTable {
public:
  /** \param[in] widths of the columns at least; missing ones count as 0 */
  GrowingTable (std::ostream& stream,
                const std::string& title,
                const std::vector<std::string>& header,
                std::vector<std::size_t> widths);

  void
  add (const std::vector<std::string>& row);

  /** \brief No more rows will come. */
  void
  end ();

private:
  void
  print (const std::vector<std::string>& cells);

  std::ostream& stream_;
  std::vector<std::size_t> widths_;
};

/** \brief A number with a fixed number of decimals; "-" for NaN. */
std::string
decimal (double number, int decimals);

/** \brief A fraction as per cent with two decimals; "-" for NaN. */
std::string
percent (double fraction);

} // namespace pcl_ops::evaluation
