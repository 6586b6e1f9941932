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

/** \brief The most columns that a line of numbers may have: far more than any cloud
 * has, so that a file of something else is refused. */
constexpr std::size_t max_columns = 1000;

/** \brief Splits a line into words, without the blanks around them.
 * \param[in] separator the character between words. A space stands for any run of
 * blanks (spaces, tabs, carriage returns). Two other separators in a row have an empty
 * word between them.
 * \param[out] words parts of \p line: they are valid as long as its characters are */
void
splitWords (std::string_view line,
            char separator,
            std::vector<std::string_view>& words);

/** \brief Reads the parts of a file for the readers of all formats: lines of a header,
 * bytes, and lines of numbers. Throws the errors of these readers, so that all formats
 * have the same messages. Offsets are from the beginning of the file, in bytes.
 *
 * A word in place of a number is an error. For such a word PCL's readers return a point
 * at zero, or one without coordinates. */
class FileReader {
public:
  /** \param[in] format e.g. "PCD", for error messages
   * \param[in] name_in_messages of the file; empty for \p file
   * \throws WorkError if the file cannot be read or is empty */
  FileReader (const std::string& file,
              std::string format,
              const std::string& name_in_messages = "");

  std::uint64_t
  fileSize () const
  {
    return file_size_;
  }

  /** \brief Returns the offset of the next byte to read. */
  std::uint64_t
  offset ()
  {
    return static_cast<std::uint64_t> (std::max<std::streamoff> (stream_.tellg(), 0));
  }

  /** \brief Sets the \ref offset of the next byte to read. */
  void
  goTo (std::uint64_t offset)
  {
    stream_.clear();
    stream_.seekg (static_cast<std::streamoff> (offset));
  }

  /** \brief Returns the number of bytes from \ref offset to the end of the file. */
  std::uint64_t
  bytesLeft ()
  {
    return file_size_ - offset();
  }

  /** \brief Reads the next \p count bytes.
   * \throws WorkError if the file ends before */
  void
  read (void* bytes, std::size_t count)
  {
    if (!stream_.read (static_cast<char*> (bytes), std::streamsize (count)))
      failTruncated();
  }

  /** \brief Reads an object without padding at an offset. */
  template <typename Object>
  Object
  readAt (std::uint64_t offset)
  {
    Object object;
    goTo (offset);
    read (&object, sizeof (object));
    return object;
  }

  /** \brief Returns the words of the next line of a header.
   * \param[in] last_key keyword of the line that ends a header, for the message
   * \throws WorkError if the file, or its first MiB, ends before the end of the next
   * line */
  Words
  nextHeaderLine (const std::string& last_key);

  /** \brief Skips the byte order mark of UTF-8 at the beginning of a text.
   * \throws WorkError if the text is UTF-16 */
  void
  skipByteOrderMark ();

  /** \brief Reads the next line into \p line; the current line stays as it is.
   * \return false at the end of the file */
  bool
  readLine (std::string& line)
  {
    ++lines_;
    return static_cast<bool> (std::getline (stream_, line));
  }

  // These functions set the current line, which is divided into words.

  /** \brief Makes the next line, a line of numbers, the current one and splits it at
   * blanks. Does not check that its words are numbers; \ref readNumber does.
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

  /** \brief Makes the next line that has a word the current one, without its comment,
   * which begins with #. Splits it at blanks.
   * \return false at the end of the file */
  bool
  nextWords ();

  /** \brief Appends following lines to the current line, seven at most, until it has \p
   * count words: RealSense's viewer writes the position of a vertex in one line, the
   * normal and the color in the next. If it never has exactly so many, the current line
   * stays as it was, but the lines that were tried are skipped: the caller has to
   * refuse the file.
   * \return the number of words of each joined line; one element if nothing was joined
   */
  std::vector<std::size_t>
  joinNextLines (std::size_t count);

  /** \brief Makes the next lines, one for each element of \p lengths, one current line.
   * \param[in] lengths number of words of each line, as from \ref joinNextLines
   * \throws WorkError if a line has another number of words, or the file ends before */
  void
  nextJoinedLines (const std::vector<std::size_t>& lengths);

  /** \brief Makes \p line the current line; see \ref splitWords. */
  void
  setLine (std::string line, char separator)
  {
    line_ = std::move (line);
    separator_ = separator;
    splitWords (line_, separator, words_);
  }

  /** \brief Removes the first word of the current line, which must have one. */
  void
  dropFirstWord ()
  {
    words_.erase (words_.begin());
  }

  // These functions read the current line. The index i of a word counts from 0.

  std::size_t
  wordCount () const
  {
    return words_.size();
  }

  const std::string_view&
  word (std::size_t i) const
  {
    return words_[i];
  }

  /** \brief Whether word \p i is empty or a number. */
  bool
  isNumber (std::size_t i) const;

  /** \brief Writes the number of word \p i into \p bytes; an empty word counts as nan.
   * \param[out] bytes as many as the type has
   * \throws WorkError if the word is no number, or a number too large for double
   * precision */
  void
  readNumber (std::size_t i, const NumberType& type, void* bytes) const;

  /** \brief Returns the number of word \p i as \ref readNumber does. */
  double
  number (std::size_t i) const;

  /** \brief Checks that the line has \p count words. Does not check whether they are
   * numbers; \ref readNumber does.
   * \param[in] may_be_text for each column, whether its word need not be a number;
   * empty: all should be numbers
   * \throws WorkError if there are more or fewer words. The error names the first word
   * that should be a number but is not; if there is no such word, the error says how
   * many words there are. */
  void
  expectWordCount (std::size_t count, const std::vector<bool>& may_be_text = {}) const;

  /** \throws WorkError unless the line has 3 to \ref max_columns words */
  void
  checkColumnCount () const;

  /** \throws WorkError if anything but blanks follows in the file */
  void
  expectEnd ();

  /** \brief Returns a count, such as a number of points, that a header has as text.
   * \param[in] what the count, for the message
   * \throws WorkError if \p text is no whole number, or above the largest value of
   * pcl::index_t */
  std::uint64_t
  parseCount (const std::string& what, const std::string& text) const;

  /** \brief Throws a WorkError: the file is no valid file of its format. */
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

  /** \brief Names of the file and of its format, for messages. */
  std::string file_, format_;
  /** \brief The current line, the separator of \ref setLine, and the line's words. */
  std::string line_;
  char separator_ = ' ';
  std::vector<std::string_view> words_;
  std::ifstream stream_;
  std::uint64_t file_size_ = 0;
  /** \brief Number of lines read so far: the number of the last one, from 1 on. */
  std::uint64_t lines_ = 0;
};

} // namespace pcl_ops::apps
