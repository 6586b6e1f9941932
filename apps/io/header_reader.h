// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "number_types.h"

#include <cstdint>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace pcl_ops::apps {

using Words = std::vector<std::string>;

/** \brief Reads the header in front of a cloud file's data, text in most formats, and
 * the data that is looked at here, and words the complaints about them. */
class HeaderReader {
public:
  /** \param[in] format e.g. "PCD", for the complaints */
  HeaderReader (const std::string& file, std::string format);

  /** \brief The words of the next line.
   * \throws WorkError if the file or the first MiB of it ends before the line \p last,
   * which ends the header */
  Words
  nextLine (const std::string& last);

  /** \brief Offset of the next byte. */
  std::uint64_t
  position ();

  void
  goTo (std::uint64_t position);

  std::uint64_t
  fileSize () const
  {
    return file_size_;
  }

  void
  read (char* bytes, std::size_t count);

  /** \brief The next line as it is, without its end. \return false where there is none
   */
  bool
  readLine (std::string& line);

  /** \brief A whole number from 0 on. */
  std::uint64_t
  number (const std::string& what, const std::string& text) const;

  /** \brief A number of points: as many as PCL's indices can tell apart. */
  std::uint64_t
  count (const std::string& what, const std::string& text) const;

  [[noreturn]] void
  fail (const std::string& reason) const;

  /** \param[in] reason what is wrong with the line that was read last */
  [[noreturn]] void
  failAtLine (const std::string& reason) const;

  [[noreturn]] void
  failTruncated () const;

  [[noreturn]] void
  failEmpty () const;

private:
  std::string file_, format_, line_;
  std::ifstream stream_;
  std::uint64_t file_size_ = 0, lines_ = 0;
};

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
