// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <string>
#include <type_traits>
#include <vector>

namespace pcl_ops::apps {

/** \brief Numbers as this machine has them, for files that only a run and its
 * continuation read. */
template <typename Number>
void
putBytes (std::ostream& stream, const Number* numbers, std::size_t count)
{
  static_assert (std::is_trivially_copyable_v<Number>, "a file has its bytes");
  stream.write (reinterpret_cast<const char*> (numbers),
                static_cast<std::streamsize> (count * sizeof (Number)));
}

template <typename Number>
void
getBytes (std::istream& stream, Number* numbers, std::size_t count)
{
  static_assert (std::is_trivially_copyable_v<Number>, "a file has its bytes");
  stream.read (reinterpret_cast<char*> (numbers),
               static_cast<std::streamsize> (count * sizeof (Number)));
}

template <typename Number>
void
put (std::ostream& stream, const Number& number)
{
  putBytes (stream, &number, 1);
}

template <typename Number>
Number
get (std::istream& stream)
{
  Number number{};
  getBytes (stream, &number, 1);
  return number;
}

/** \brief Reads how many parts follow. \return 0, and the stream has failed, where the
 * file has not that many \param[in] part_size the fewest bytes of one */
std::uint64_t
getCount (std::istream& stream, std::size_t part_size);

template <typename Number>
void
putAll (std::ostream& stream, const std::vector<Number>& numbers)
{
  put (stream, std::uint64_t (numbers.size()));
  putBytes (stream, numbers.data(), numbers.size());
}

template <typename Number>
std::vector<Number>
getAll (std::istream& stream)
{
  std::vector<Number> numbers (getCount (stream, sizeof (Number)));
  getBytes (stream, numbers.data(), numbers.size());
  return numbers;
}

/** \brief Opens a file of a run.
 * \throws WorkError that names it if that fails */
std::ifstream
openBinary (const std::string& file);

/** \throws WorkError that names a file of a run, whose numbers make no sense */
[[noreturn]] void
failDamaged (const std::string& file);

/** \throws WorkError that names the file if it ended before what was read from it */
void
checkWasRead (const std::istream& stream, const std::string& file);

} // namespace pcl_ops::apps
