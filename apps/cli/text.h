// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <sstream>
#include <string>

namespace pcl_ops::apps {

/** \brief Returns the values one after the other as a stream writes them: words
 * unchanged, numbers with up to six significant digits. */
template <typename... Values>
std::string
concatenate (const Values&... values)
{
  std::ostringstream text;
  (text << ... << values);
  return text.str();
}

/** \brief Returns a number with its noun: "1 plane", "2 planes". */
inline std::string
counted (std::size_t number, const std::string& noun)
{
  return std::to_string (number) + " " + noun + (number == 1 ? "" : "s");
}

/** \brief Returns the text with a blank in place of each \n and each \r. File names may
 * have line breaks. */
inline std::string
oneLine (std::string text)
{
  for (char& c : text)
    c = c == '\n' || c == '\r' ? ' ' : c;
  return text;
}

/** \brief Returns the text with U+FFFD in place of each byte that is not part of a
 * valid UTF-8 character. File names may have such bytes. */
std::string
validUtf8 (const std::string& text);

} // namespace pcl_ops::apps
