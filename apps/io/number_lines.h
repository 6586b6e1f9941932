// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "header_reader.h"

#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief Reads the numbers of a line: `nan`, `inf` and `infinity`, too, but none that
 * is too large.
 * \param[in] reader whose last line it is, for complaints
 * \param[in] separator a comma or semicolon between numbers, where nothing is NaN; a
 * space: blanks alone are between them
 * \throws WorkError for words and numbers beyond their type */
void
readNumbers (const HeaderReader& reader,
             const std::string& line,
             char separator,
             std::vector<double>& numbers);

/** \brief The lines of a cloud's data that is text. PCL's readers make points at zero
 * or without coordinates of what they do not understand; here it is refused. */
class NumberLines {
public:
  /** \param[in] reader at the end of the header */
  explicit NumberLines (HeaderReader& reader) : reader_ (reader) {}

  /** \brief Reads the numbers of the next line.
   * \return false where the line has not a single character
   * \throws WorkError for words, or if there is no further line */
  bool
  next ();

  /** \brief Those of the line that was read last. */
  const std::vector<double>&
  numbers () const
  {
    return numbers_;
  }

  /** \throws WorkError unless the line has so many numbers */
  void
  expectNumbers (std::size_t count) const;

  /** \throws WorkError if there is more than white space left */
  void
  expectEnd ();

private:
  HeaderReader& reader_;
  std::string line_;
  std::vector<double> numbers_;
};

} // namespace pcl_ops::apps
