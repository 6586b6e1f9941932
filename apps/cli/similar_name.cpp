// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "similar_name.h"

#include <algorithm>
#include <cstddef>

namespace pcl_ops::apps {

namespace {

/** \brief Returns the edit distance of two words: how many letters are inserted,
 * deleted, changed or swapped with the next (optimal string alignment). */
std::size_t
editsBetween (const std::string& a, const std::string& b)
{
  // edits[i][j] is the distance between the first i letters of a and the first j of b.
  std::vector<std::vector<std::size_t>> edits (a.size() + 1,
                                               std::vector<std::size_t> (b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i)
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        edits[i][j] = i + j;
        continue;
      }
      const std::size_t changed = edits[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      const std::size_t deleted = edits[i - 1][j] + 1;
      const std::size_t inserted = edits[i][j - 1] + 1;
      edits[i][j] = std::min ({deleted, inserted, changed});
      const bool are_swapped =
          i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (are_swapped)
        edits[i][j] = std::min (edits[i][j], edits[i - 2][j - 2] + 1);
    }
  return edits.back().back();
}

} // namespace

std::string
similarName (const std::string& mistyped, const std::vector<std::string>& names)
{
  // A longer word is no mistyped name; the time grows with the length.
  constexpr std::size_t max_length = 64;
  if (mistyped.size() > max_length)
    return "";
  std::string similar;
  // With more edits the name would hardly be recognized in the word; chosen by hand.
  const std::size_t max_edits = mistyped.size() / 3;
  std::size_t fewest_edits = max_edits + 1;
  for (const std::string& name : names)
    if (const std::size_t edits = editsBetween (mistyped, name); edits < fewest_edits) {
      fewest_edits = edits;
      similar = name;
    }
  return similar;
}

} // namespace pcl_ops::apps
