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

/** \brief How many columns a line of numbers may have. */
constexpr std::size_t max_columns = 1000;

/** \brief The words of a line, without blanks around them.
 * \param[in] separator between words that may be empty; a space: any blanks */
void
splitWords (std::string_view line,
            char separator,
            std::vector<std::string_view>& words);

/** \brief Reads the parts of a cloud file for the readers of all formats: lines of a
 * header, bytes, and lines of numbers. It also words their error messages.
 *
 * A word in place of a number is refused; PCL's readers make a point at zero, or one
 * without coordinates, of it. */
class HeaderReader {
public:
  /** \param[in] format e.g. "PCD", for the complaints */
  HeaderReader (const std::string& file, std::string format);

  /** \brief The words of the next line of a header.
   * \throws WorkError if the file or its first MiB ends before the line \p last of it */
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

  /** \brief What is at a place of the file, without padding. */
  template <typename What>
  What
  at (std::uint64_t place)
  {
    What what;
    goTo (place);
    read (&what, sizeof (what));
    return what;
  }

  /** \return false where there is no further line */
  bool
  readLine (std::string& line)
  {
    ++lines_;
    return static_cast<bool> (std::getline (stream_, line));
  }

  /** \brief Goes on to the next line of numbers.
   * \return false if the line is empty
   * \throws WorkError at the end of the file */
  bool
  nextNumbers ()
  {
    if (!readLine (line_))
      failTruncated();
    splitWords (line_, ' ', words_);
    return !line_.empty();
  }

  /** \brief Adds the lines behind the line of numbers to it, if they make it have just
   * so many words: RealSense's viewer writes the position of a vertex in one line, its
   * normal and its color in the next.
   * \return how many words each line has; one number where nothing was added */
  std::vector<std::size_t>
  joinLines (std::size_t count);

  /** \brief Goes on to lines of numbers that have as many words, and makes them one.
   * \param[in] lengths as from \ref joinLines */
  void
  nextLines (const std::vector<std::size_t>& lengths);

  /** \brief Takes the line that was read last for one of numbers; see \ref splitWords.
   */
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

  /** \brief Puts a number of the line into bytes, NaN for an empty word.
   * \throws WorkError if it is none or too large for its type */
  void
  readNumber (std::size_t word, const NumberType& type, void* bytes) const;

  double
  number (std::size_t word) const;

  bool
  isNumber (std::size_t word) const;

  /** \brief Checks how many words the line has. Only \ref readNumber checks whether
   * they are numbers.
   * \param[in] may_be_words for each column whether it may have a word that is no number
   * \throws WorkError if there are more or fewer words. The error names the first word
   * that should be a number and is none; if there is no such word it says how many
   * words there are. */
  void
  expectNumbers (std::size_t count, const std::vector<bool>& may_be_words = {}) const;

  /** \throws WorkError unless the line has as many words as a point has numbers */
  void
  checkColumns () const;

  /** \throws WorkError if there is more than blanks left */
  void
  expectEnd ();

  const std::string_view&
  word (std::size_t i) const
  {
    return words_[i];
  }

  /** \brief Leaves out the first word of the line. */
  void
  dropWord ()
  {
    words_.erase (words_.begin());
  }

  /** \brief Leaves out the mark of UTF-8 that a text may begin with.
   * \throws WorkError if it is UTF-16 */
  void
  skipMark ();

  /** \brief Goes on to the next line with a word in front of a #, which begins a
   * comment. Of text only.
   * \return false where there is none */
  bool
  nextWords ();

  /** \brief A number of points from a text.
   * \throws WorkError if it is no number, or more than PCL's indices can tell apart */
  std::uint64_t
  count (const std::string& what, const std::string& text) const;

  [[noreturn]] void
  fail (const std::string& reason) const;

  /** \brief About the line that was read last. */
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
  /** \brief About a word in place of a number. */
  [[noreturn]] void
  failAtWord (const std::string& word) const;

  std::string file_, format_, line_;
  std::vector<std::string_view> words_;
  std::ifstream stream_;
  std::uint64_t file_size_ = 0, lines_ = 0;
};

} // namespace pcl_ops::apps
