// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "text.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace pcl_ops::apps {

namespace {

/** \brief Returns the number of bytes of the UTF-8 character that this byte begins; 0
 * if it begins none. */
std::size_t
lengthOfCharacter (unsigned char first)
{
  if (first < 0x80)
    return 1;
  if (first < 0xc2)
    return 0;
  return first < 0xe0 ? 2 : first < 0xf0 ? 3 : first < 0xf5 ? 4 : 0;
}

/** \brief Whether the bytes are one UTF-8 character in its shortest form, and no UTF-16
 * surrogate. */
bool
isCharacter (const std::string& bytes)
{
  constexpr std::uint32_t smallest[] = {0, 0, 0x80, 0x800, 0x10000};
  constexpr std::uint32_t largest = 0x10ffff;
  const std::size_t length = bytes.size();
  if (length == 1)
    return true;
  std::uint32_t code = static_cast<unsigned char> (bytes[0]) & (0x7fU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    const auto byte = static_cast<unsigned char> (bytes[i]);
    if ((byte & 0xc0U) != 0x80U)
      return false;
    code = code << 6U | (byte & 0x3fU);
  }
  return code >= smallest[length] && code <= largest &&
         (code < 0xd800 || code > 0xdfff);
}

} // namespace

std::string
validUtf8 (const std::string& text)
{
  std::string valid;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = lengthOfCharacter (static_cast<unsigned char> (text[i]));
    const std::string bytes = text.substr (i, std::max<std::size_t> (length, 1));
    const bool is_one = length > 0 && bytes.size() == length && isCharacter (bytes);
    valid += is_one ? bytes : "\xef\xbf\xbd";
    i += is_one ? length : 1;
  }
  return valid;
}

} // namespace pcl_ops::apps
