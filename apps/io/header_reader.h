// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "number_types.h"
#include <cli/errors.h>

#include <algorithm>
#include <fstream>
#include <utility>
#include <vector>

namespace pcl_ops::apps {

using Words = std::vector<std::string>;

/** \brief The most columns that a line of numbers may have. */
constexpr std::size_t max_columns = 1000;

/** \brief Splits a line into words, without the blanks around them.
 * \param[in] separator a character between words, which may then be empty; a space
 * stands for any run of blanks */
void
splitWords (std::string_view line,
            char separator,
            std::vector<std::string_view>& words);

/** \brief Reads the parts of a cloud file for the readers of all formats: lines of a
 * header, bytes, and lines of numbers. It also words their error messages.
 *
 * It refuses a word in place of a number; PCL's readers make a point at zero, or one
 * without coordinates, of it. */
class HeaderReader {
public:
  /** \param[in] format e.g. "PCD", for error messages */
  HeaderReader (const std::string& file, std::string format);

  /** \brief Returns the words of the next line of the header.
   * \param[in] last name of the line that should end the header, for the message
   * \throws WorkError if the file or its first MiB ends before this line does */
  Words
  nextLine (const std::string& last);

  std::uint64_t
  position ()
  {
    return static_cast<std::uint64_t> (std::max<std::streamoff> (stream_.tellg(), 0));
  }

  void
  goTo (std::uint64_t position)
  {
    stream_.clear();
    stream_.seekg (static_cast<std::streamoff> (position));
  }

  std::uint64_t
  fileSize () const
  {
    return file_size_;
  }

  void
  read (void* bytes, std::size_t count)
  {
    if (!stream_.read (static_cast<char*> (bytes), std::streamsize (count)))
      failTruncated();
  }

  /** \brief Reads an object without padding at a byte of the file. */
  template <typename What>
  What
  at (std::uint64_t place)
  {
    What what;
    goTo (place);
    read (&what, sizeof (what));
    return what;
  }

  /** \return false at the end of the file */
  bool
  readLine (std::string& line)
  {
    ++lines_;
    return static_cast<bool> (std::getline (stream_, line));
  }

  /** \brief Reads the next line and splits it at blanks.
   * \return false if the line is empty
   * \throws WorkError at the end of the file */
  bool
  nextNumbers ()
  {
    if (!readLine (line_))
      failTruncated();
    splitWords (line_, ' ', words_);
    return !line_.empty() && line_ != "\r"; // lines may end with CR LF
  }

  /** \brief Appends the following lines to the current one if it then has exactly
   * \p count words; else leaves it unchanged. RealSense's viewer writes the position of
   * a vertex in one line, its normal and its color in the next.
   * \return the number of words of each joined line; one element if nothing was joined
   */
  std::vector<std::size_t>
  joinLines (std::size_t count);

  /** \brief Reads as many lines as \p lengths has elements, each with that many words,
   * and joins them.
   * \param[in] lengths as from \ref joinLines */
  void
  nextLines (const std::vector<std::size_t>& lengths);

  /** \brief Makes \p line the current line of numbers; see \ref splitWords. */
  void
  takeNumbers (std::string line, char separator)
  {
    line_ = std::move (line);
    splitWords (line_, separator, words_);
  }

  std::size_t
  wordCount () const
  {
    return words_.size();
  }

  /** \brief Writes the number of a word of the line into \p bytes; an empty word counts
   * as nan.
   * \param[in] word index in the line, from 0
   * \throws WorkError if it is no number or too large for double precision */
  void
  readNumber (std::size_t word, const NumberType& type, void* bytes) const;

  double
  number (std::size_t word) const;

  bool
  isNumber (std::size_t word) const;

  /** \brief Checks that the line has \p count words. It does not check whether they are
   * numbers; \ref readNumber does.
   * \param[in] may_be_words for each column, whether its word need not be a number
   * \throws WorkError if there are more or fewer words. The error names the first word
   * that should be a number but is not; if there is no such word, it says how many
   * words there are. */
  void
  expectNumbers (std::size_t count, const std::vector<bool>& may_be_words = {}) const;

  /** \throws WorkError unless the line has 3 to \ref max_columns words */
  void
  checkColumns () const;

  /** \throws WorkError if anything but blanks follows in the file */
  void
  expectEnd ();

  const std::string_view&
  word (std::size_t i) const
  {
    return words_[i];
  }

  /** \brief Removes the first word of the line. */
  void
  dropWord ()
  {
    words_.erase (words_.begin());
  }

  /** \brief Skips the byte order mark of UTF-8 at the beginning of a text.
   * \throws WorkError if the text is UTF-16 */
  void
  skipMark ();

  /** \brief Reads the next line of a text that has a word, without its comment, which
   * begins with #.
   * \return false at the end of the file */
  bool
  nextWords ();

  /** \brief Returns a count, such as a number of points, that a header has as text.
   * \param[in] what the count, for the message
   * \throws WorkError if \p text is no whole number, or more than PCL's indices can
   * tell apart */
  std::uint64_t
  count (const std::string& what, const std::string& text) const;

  [[noreturn]] void
  fail (const std::string& reason) const;

  /** \brief Throws a WorkError about the line that was read last. */
  [[noreturn]] void
  failAtLine (const std::string& reason) const;

  [[noreturn]] void
  failTruncated () const
  {
    throw WorkError (file_,
                     "is truncated: its header promises more points than follow; "
                     "copy or write it again");
  }

  [[noreturn]] void
  failEmpty () const
  {
    throw WorkError (file_, "has no points; give a cloud that has");
  }

private:
  /** \brief Throws a WorkError about a word in place of a number. */
  [[noreturn]] void
  failAtWord (const std::string& word) const;

  std::string file_, format_, line_;
  std::vector<std::string_view> words_;
  std::ifstream stream_;
  std::uint64_t file_size_ = 0, lines_ = 0;
};

} // namespace pcl_ops::apps
