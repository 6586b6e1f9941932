// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sstream>
#include <string>

namespace pcl_ops::apps {

/** \brief Values one after the other, as a stream writes them: words as they are,
 * numbers with up to six digits. */
template <typename... Values>
std::string
concatenate (const Values&... values)
{
  std::ostringstream text;
  (text << ... << values);
  return text.str();
}

/** \brief With a blank in place of each line break, which names of files may have. */
inline std::string
oneLine (std::string text)
{
  for (char& c : text)
    c = c == '\n' || c == '\r' ? ' ' : c;
  return text;
}

/** \brief With U+FFFD in place of each byte that is no part of a character of UTF-8, as
 * names of files may have. */
std::string
validUtf8 (const std::string& text);

} // namespace pcl_ops::apps
