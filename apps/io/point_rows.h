// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/PCLPointCloud2.h>

#include "header_reader.h"

#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief Makes a cloud from lines of numbers, one line for each point. Declare the
 * columns first, from the left. */
class PointRows {
public:
  explicit PointRows (HeaderReader& reader) : reader_ (reader) {}

  /** \param[in] datatype a type of pcl::PCLPointField */
  void
  addColumn (const std::string& name, std::uint8_t datatype);

  /** \brief Declares three columns, red, green and blue, which become PCL's packed
   * color. */
  void
  addColor ();

  /** \brief Declares a column of words, which becomes no field. */
  void
  skipColumn ();

  /** \brief Declares all columns of the current line in double precision: x, y, z and
   * further ones.
   * \param[in] further names of the columns behind z; if their number differs, the
   * columns become field_4, field_5, ... */
  void
  addColumnsOfLine (const Words& further);

  /** \brief Adds the line that was read last as a point.
   * \throws WorkError if its columns differ from those declared, or there are more
   * points than PCL's indices can tell apart */
  void
  addPoint ();

  std::size_t
  size () const
  {
    return size_;
  }

  /** \brief Returns where the bytes of the last point begin. */
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

  /** \brief The points so far; width and height are 0 until \ref take. */
  pcl::PCLPointCloud2 cloud;

  /** \brief Returns the cloud, unorganized.
   * \throws WorkError if it has no points */
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
