// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "header_reader.h"
#include "las_header.h"

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief Bytes that a copy of a file has in place of some. */
struct LasEdit {
  std::uint64_t begin, replaced;
  std::string bytes;
};

/** \brief How much longer a copy is than the file. */
struct LasGrowth {
  /** \brief Variable length records more, and bytes in front of the points. */
  std::int64_t vlrs = 0, front = 0;
  /** \brief Where the points of the file end, and the bytes more in front of what is
   * there. */
  std::uint64_t points_end = 0;
  std::int64_t all = 0;
};

/** \brief What the header of such a copy has in other words. */
std::vector<LasEdit>
editsForGrowth (const HeaderReader& reader,
                const LasHeader& header,
                const LasGrowth& growth);

/** \brief Copies a part of the file.
 * \param[in] edits none of which reaches beyond the part */
void
copyEdited (HeaderReader& reader,
            std::uint64_t begin,
            std::uint64_t end,
            std::vector<LasEdit> edits,
            std::ostream& stream);

} // namespace pcl_ops::apps
