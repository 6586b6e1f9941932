// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/PCLPointCloud2.h>

#include "header_reader.h"

#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief Makes a cloud of lines of numbers, one for each point. Columns are told
 * first, from the left. */
class PointRows {
public:
  explicit PointRows (HeaderReader& reader) : reader_ (reader) {}

  /** \param[in] datatype of pcl::PCLPointField */
  void
  addColumn (const std::string& name, std::uint8_t datatype);

  /** \brief Three columns that become PCL's packed color. */
  void
  addColor ();

  /** \brief A column of words, which no field has room for. */
  void
  skipColumn ();

  /** \brief x, y, z and further columns, as many as the line has, in double precision.
   * \param[in] further their names; where they are not as many, field_4, field_5, ...
   */
  void
  addColumnsOfLine (const Words& further);

  /** \brief Takes the line that was read last.
   * \throws WorkError if it has other columns, or points are more than PCL's indices
   * can tell apart */
  void
  addPoint ();

  std::size_t
  size () const
  {
    return size_;
  }

  /** \brief Where the fields of the last point are. */
  std::uint8_t*
  lastPoint ()
  {
    return cloud.data.data() + (size_ - 1) * cloud.point_step;
  }

  bool
  hasColumns () const
  {
    return !are_words_.empty();
  }

  /** \brief The points so far, of size 0 until \ref take. */
  pcl::PCLPointCloud2 cloud;

  /** \brief The cloud, unorganized. \throws WorkError if it has no points */
  pcl::PCLPointCloud2
  take ();

private:
  struct Column {
    std::size_t word;
    const NumberType* type;
    pcl::uindex_t offset;
  };

  HeaderReader& reader_;
  std::vector<Column> columns_;
  std::vector<bool> are_words_;
  std::size_t size_ = 0;
};

} // namespace pcl_ops::apps
