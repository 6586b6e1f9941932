// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "help_text.h"

#include <algorithm>
#include <sstream>

namespace pcl_ops::apps {

std::string
listed (const std::vector<std::pair<std::string, std::string>>& entries,
        std::size_t width)
{
  constexpr std::size_t kMargin = 2, kGap = 3;
  std::size_t longest = 0;
  for (const auto& entry : entries)
    longest = std::max (longest, entry.first.size());
  const std::size_t column = kMargin + longest + kGap;
  std::string text;
  for (const auto& [name, meaning] : entries) {
    std::string line = std::string (kMargin, ' ') + name;
    line.resize (column - 1, ' ');
    std::istringstream words (meaning);
    for (std::string word; words >> word;) {
      if (line.size() > column && line.size() + 1 + word.size() > width) {
        text += line + "\n";
        line.assign (column - 1, ' ');
      }
      line += ' ' + word;
    }
    text += line + "\n";
  }
  return text;
}

} // namespace pcl_ops::apps
