// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/PCLPointCloud2.h>

#include "file_reader.h"

#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief Makes a cloud from lines of numbers, one line for each point. Declare the
 * columns first, from left to right. Before each \ref addPoint, make the reader go on
 * to the line of the point. */
class PointRows {
public:
  explicit PointRows (FileReader& reader) : reader_ (reader) {}

  /** \brief Declares a column of numbers, which becomes a field.
   * \param[in] datatype of the field, a type of pcl::PCLPointField */
  void
  addColumn (const std::string& name, std::uint8_t datatype);

  /** \brief Declares three columns, red, green and blue, which become PCL's packed
   * color. */
  void
  addColor ();

  /** \brief Declares a column of words, which becomes no field. */
  void
  skipColumn ();

  /** \brief Declares all columns of the reader's current line in double precision: x,
   * y, z and further ones.
   * \param[in] names_behind_z names of the further columns. If there are more or fewer
   * names than such columns, the columns are called field_4, field_5, ...
   * \throws WorkError unless the line has 3 to \ref max_columns words */
  void
  addColumnsOfLine (const Words& names_behind_z);

  /** \brief Adds the reader's current line as a point.
   * \throws WorkError if the line has more or fewer words than columns are declared, or
   * a word in a column of numbers is none, or there are more points than PCL's indices
   * can number */
  void
  addPoint ();

  /** \brief Number of points so far. */
  std::size_t
  size () const
  {
    return size_;
  }

  /** \brief Returns a pointer to the first byte of the last point; there must be one.
   */
  std::uint8_t*
  lastPoint ()
  {
    return cloud.data.data() + (size_ - 1) * cloud.point_step;
  }

  bool
  hasColumns () const
  {
    return !is_skipped_.empty();
  }

  /** \brief The points so far; width and height are 0 until \ref take. */
  pcl::PCLPointCloud2 cloud;

  /** \brief Returns the cloud, unorganized, and leaves this object without it.
   * \throws WorkError if it has no points */
  pcl::PCLPointCloud2
  take ();

private:
  /** \brief A column of numbers, which become a field or a byte of the color. */
  struct Column {
    /** \brief Index in a line of the word with the number. */
    std::size_t word;
    /** \brief Type of the number in the cloud. */
    const NumberType* type;
    /** \brief Offset of the number in a point [bytes]. */
    pcl::uindex_t offset;
  };

  FileReader& reader_;
  std::vector<Column> columns_;
  /** \brief For each column that was declared, whether it is skipped. */
  std::vector<bool> is_skipped_;
  std::size_t size_ = 0;
};

} // namespace pcl_ops::apps
