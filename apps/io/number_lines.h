// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "header_reader.h"
#include "number_types.h"

#include <string>
#include <string_view>
#include <vector>

namespace pcl_ops::apps {

/** \brief The words of a line, without blanks around them.
 * \param[in] separator a comma or semicolon between words, of which some may be empty;
 * a space: blanks alone are between them */
void
splitWords (std::string_view line,
            char separator,
            std::vector<std::string_view>& words);

/** \brief The lines of a cloud's data that is text. What is no number is refused;
 * PCL's readers make points at zero or without coordinates of it. */
class NumberLines {
public:
  /** \param[in] reader at the end of the header */
  explicit NumberLines (HeaderReader& reader) : reader_ (reader) {}

  /** \brief Goes on to the next line, which has words between blanks.
   * \return false where the line has not a single character
   * \throws WorkError if there is no further line */
  bool
  next ();

  /** \brief Takes the line that the reader read last; see \ref splitWords. */
  void
  take (std::string line, char separator);

  std::size_t
  size () const
  {
    return words_.size();
  }

  /** \brief Puts a number of the line into bytes, NaN for an empty word.
   * \throws WorkError if it is none or too large for its type */
  void
  read (std::size_t word, const NumberType& type, std::uint8_t* bytes) const;

  double
  number (std::size_t word) const;

  /** \throws WorkError unless the line has so many numbers */
  void
  expectNumbers (std::size_t count) const;

  /** \throws WorkError if there is more than white space left */
  void
  expectEnd ();

private:
  HeaderReader& reader_;
  std::string line_;
  std::vector<std::string_view> words_;
};

} // namespace pcl_ops::apps
