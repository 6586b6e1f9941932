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

} // namespace pcl_ops::apps
