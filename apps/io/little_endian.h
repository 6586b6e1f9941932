// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>

namespace pcl_ops::apps {

/** \brief An integer from its bytes, the lowest first, on any host. */
template <typename Integer>
Integer
fromLittleEndian (const char* bytes)
{
  std::uint64_t bits = 0;
  for (std::size_t i = sizeof (Integer); i-- > 0;)
    bits = bits << 8U | static_cast<unsigned char> (bytes[i]);
  return static_cast<Integer> (static_cast<std::make_unsigned_t<Integer>> (bits));
}

inline double
doubleFromLittleEndian (const char* bytes)
{
  const auto bits = fromLittleEndian<std::uint64_t> (bytes);
  double number;
  std::memcpy (&number, &bits, sizeof (number));
  return number;
}

/** \brief The bytes of an unsigned integer, the lowest first. */
template <typename Unsigned>
std::string
littleEndian (Unsigned number)
{
  std::string bytes (sizeof (number), '\0');
  auto bits = static_cast<std::uint64_t> (number);
  for (char& byte : bytes) {
    byte = static_cast<char> (static_cast<unsigned char> (bits & 0xffU));
    bits >>= 8U;
  }
  return bytes;
}

} // namespace pcl_ops::apps
