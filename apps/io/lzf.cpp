// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lzf.h"

#include <algorithm>
#include <cstddef>

namespace pcl_ops::apps {

bool
decompressLzf (const std::vector<std::uint8_t>& compressed,
               std::vector<std::uint8_t>& bytes)
{
  constexpr std::size_t literals = 32, longest_in_head = 7;
  std::size_t out = 0;
  for (std::size_t in = 0; in < compressed.size();) {
    const std::size_t head = compressed[in++];
    if (head < literals) { // as many bytes and one more as they are
      const std::size_t count = head + 1;
      if (count > compressed.size() - in || count > bytes.size() - out)
        return false;
      std::copy_n (&compressed[in], count, &bytes[out]);
      in += count;
      out += count;
      continue;
    }
    std::size_t count = head / literals; // of bytes that were there before
    const std::size_t rest = count == longest_in_head ? 2 : 1;
    if (rest > compressed.size() - in)
      return false;
    if (count == longest_in_head)
      count += compressed[in++];
    count += 2;
    const std::size_t distance = head % literals * 256 + compressed[in++] + 1;
    if (distance > out || count > bytes.size() - out)
      return false;
    for (; count > 0; --count, ++out) // may read what it writes
      bytes[out] = bytes[out - distance];
  }
  return out == bytes.size();
}

} // namespace pcl_ops::apps
