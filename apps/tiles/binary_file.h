// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cli/errors.h>

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <string>
#include <type_traits>
#include <vector>

namespace pcl_ops::apps {

/** \brief Writes numbers as this machine has them, for files that only a run and its
 * continuation read. */
class BinaryWriter {
public:
  explicit BinaryWriter (std::ostream& stream) : stream_ (stream) {}

  template <typename Number>
  void
  operator() (const Number* numbers, std::size_t count)
  {
    static_assert (std::is_trivially_copyable_v<Number>, "a file has its bytes");
    stream_.write (reinterpret_cast<const char*> (numbers), count * sizeof (Number));
  }

  template <typename Number>
  void
  operator() (const std::vector<Number>& numbers)
  {
    const std::uint64_t count = numbers.size();
    (*this) (&count, 1);
    (*this) (numbers.data(), numbers.size());
  }

private:
  std::ostream& stream_;
};

/** \brief Reads them. Where the file is missing, or has not what is asked for, it
 * throws a WorkError. */
class BinaryReader {
public:
  explicit BinaryReader (const std::string& file)
  : file_ (file), stream_ (file, std::ios::binary | std::ios::ate)
  {
    if (!stream_)
      throw WorkError (file, "cannot be read; remove its folder and run it again");
    size_ = stream_.tellg();
    seek (0);
  }

  std::uint64_t
  size () const
  {
    return size_;
  }

  void
  seek (std::uint64_t place)
  {
    stream_.seekg (place);
  }

  template <typename Number>
  void
  operator() (Number* numbers, std::size_t count)
  {
    static_assert (std::is_trivially_copyable_v<Number>, "a file has its bytes");
    if (!stream_.read (reinterpret_cast<char*> (numbers), count * sizeof (Number)))
      fail();
  }

  template <typename Number>
  void
  operator() (std::vector<Number>& numbers)
  {
    std::uint64_t count = 0;
    (*this) (&count, 1);
    if (count > size_ / sizeof (Number))
      fail();
    numbers.resize (count);
    (*this) (numbers.data(), count);
  }

  [[noreturn]] void
  fail () const
  {
    throw WorkError (file_, "is damaged; remove its folder and run it again");
  }

private:
  std::string file_;
  std::ifstream stream_;
  std::uint64_t size_ = 0;
};

} // namespace pcl_ops::apps
