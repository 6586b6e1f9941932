// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "text.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace pcl_ops::apps {

namespace {

/** \brief Returns the number of bytes of the UTF-8 character that begins with this
 * byte; 0 if none does. */
std::size_t
lengthOfCharacter (unsigned char first)
{
  if (first <= 0x7f) // ASCII
    return 1;
  // The second or a later byte of a character, or the first one of a form that is not
  // the shortest.
  if (first <= 0xc1)
    return 0;
  if (first <= 0xdf)
    return 2;
  if (first <= 0xef)
    return 3;
  return first <= 0xf4 ? 4 : 0; // 0xf5 would begin a code above 0x10ffff
}

/** \brief Whether the bytes are one UTF-8 character: the shortest form of a code that
 * is no UTF-16 surrogate.
 * \param[in] bytes as many as \ref lengthOfCharacter returns for the first one */
bool
isCharacter (const std::string& bytes)
{
  constexpr std::uint32_t min_code_of_length[] = {0, 0, 0x80, 0x800, 0x10000};
  constexpr std::uint32_t max_code = 0x10ffff;
  constexpr std::uint32_t first_surrogate = 0xd800, last_surrogate = 0xdfff;
  const std::size_t length = bytes.size();
  if (length == 1)
    return true;
  // The first byte begins with as many bits 1 as the character has bytes, then a bit 0;
  // each further byte begins with the bits 10. All other bits are those of the code.
  std::uint32_t code = static_cast<unsigned char> (bytes[0]) & (0x7fU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    const auto byte = static_cast<unsigned char> (bytes[i]);
    if ((byte & 0xc0U) != 0x80U)
      return false;
    code = code << 6U | (byte & 0x3fU);
  }
  const bool is_surrogate = code >= first_surrogate && code <= last_surrogate;
  return code >= min_code_of_length[length] && code <= max_code && !is_surrogate;
}

} // namespace

std::string
validUtf8 (const std::string& text)
{
  std::string valid;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = lengthOfCharacter (static_cast<unsigned char> (text[i]));
    const std::string bytes = text.substr (i, std::max<std::size_t> (length, 1));
    const bool is_character =
        length > 0 && bytes.size() == length && isCharacter (bytes);
    constexpr const char* replacement = "\xef\xbf\xbd"; // U+FFFD
    valid += is_character ? bytes : replacement;
    i += is_character ? length : 1;
  }
  return valid;
}

} // namespace pcl_ops::apps
