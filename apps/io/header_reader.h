// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <fstream>
#include <string>
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
  /** \return false where it does not end within what a header may have */
  bool
  readHeaderLine ();

  std::string file_, format_, line_;
  std::ifstream stream_;
  std::uint64_t file_size_ = 0, lines_ = 0;
};

} // namespace pcl_ops::apps
