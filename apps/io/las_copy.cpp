// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "las_copy.h"

#include "little_endian.h"

#include <algorithm>
#include <ostream>

namespace pcl_ops::apps {

std::vector<LasEdit>
editsForGrowth (const HeaderReader& reader,
                const LasHeader& header,
                const LasGrowth& growth)
{
  // Unsigned sums wrap to what is meant where a copy is shorter.
  const auto moved = [&] (std::uint64_t offset) {
    const bool is_behind = offset >= growth.points_end && offset <= reader.fileSize();
    return littleEndian (is_behind ? offset + static_cast<std::uint64_t> (growth.all)
                                   : offset);
  };
  std::vector<LasEdit> edits = {
      {las_field::points_offset,
       4,
       littleEndian (static_cast<std::uint32_t> (header.points_offset + growth.front))},
      {las_field::vlr_count,
       4,
       littleEndian (static_cast<std::uint32_t> (header.vlr_count + growth.vlrs))}};
  if (header.minor_version >= 3)
    edits.push_back ({las_field::waveform_offset, 8, moved (header.waveform_offset)});
  if (header.minor_version >= 4)
    edits.push_back ({las_field::evlr_offset, 8, moved (header.evlr_offset)});
  return edits;
}

void
copyEdited (HeaderReader& reader,
            std::uint64_t begin,
            std::uint64_t end,
            std::vector<LasEdit> edits,
            std::ostream& stream)
{
  constexpr std::uint64_t block = 1U << 20U;
  std::vector<char> bytes (std::min (block, end - begin));
  std::stable_sort (edits.begin(), edits.end(), [] (const auto& a, const auto& b) {
    return a.begin < b.begin;
  });
  edits.push_back ({end, 0, ""});
  for (const LasEdit& edit : edits) {
    reader.goTo (begin);
    while (begin < edit.begin) {
      const std::uint64_t count = std::min<std::uint64_t> (block, edit.begin - begin);
      reader.read (bytes.data(), count);
      stream.write (bytes.data(), static_cast<std::streamsize> (count));
      begin += count;
    }
    stream << edit.bytes;
    begin += edit.replaced;
  }
}

} // namespace pcl_ops::apps
