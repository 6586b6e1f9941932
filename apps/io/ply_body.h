// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "header_reader.h"

#include <cstdint>
#include <string>
#include <vector>

namespace pcl_ops::apps {

struct PlyProperty {
  std::string name;
  /** \brief Types are those of pcl::PCLPointField. */
  std::uint8_t type = 0;
  bool is_list = false;
  /** \brief Type of the length in front of a list. */
  std::uint8_t length_type = 0;
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
};

/** \brief What a header says about the data behind it. */
struct PlyLayout {
  /** \brief ascii, binary_little_endian or binary_big_endian. */
  std::string format;
  /** \brief In the order of the data. */
  std::vector<PlyElement> elements;

  /** \return nullptr if there is none of that name */
  const PlyElement*
  find (const std::string& name) const;
};

/** \brief Checks the data that PCL's reader takes for granted: that text is numbers, as
 * many as promised, and that a range_grid names vertices that exist.
 * \param[in] reader at the end of the header
 * \throws WorkError naming what is wrong */
void
checkPlyBody (HeaderReader& reader, const PlyLayout& layout);

} // namespace pcl_ops::apps
