// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "header_reader.h"
#include "number_types.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace pcl_ops::apps {

struct PlyProperty {
  std::string name;
  const NumberType* type = nullptr;
  /** \brief Type of the length in front of a list; nullptr: no list. */
  const NumberType* length_type = nullptr;
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  /** \brief ascii, binary_little_endian or binary_big_endian. */
  std::string format;
  /** \brief In the order of the data. */
  std::vector<PlyElement> elements;
  /** \brief "obj_info num_cols N" and "num_rows N". */
  std::map<std::string, double> grid;

  /** \return nullptr if there is none of that name */
  const PlyElement*
  find (const std::string& name) const;
};

/** \throws WorkError naming the line at fault, or if there are no vertices or they have
 * lists or twice the same property */
PlyHeader
readPlyHeader (HeaderReader& reader);

} // namespace pcl_ops::apps
