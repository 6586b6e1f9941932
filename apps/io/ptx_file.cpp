// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/PCLPointField.h>

#include "cloud_formats.h"
#include "file_reader.h"
#include "point_rows.h"

#include <cmath>
#include <cstring>
#include <limits>

namespace pcl_ops::apps {

namespace {

using pcl::PCLPointField;

/** \brief The header of a scan in a PTX. The common frame is that of all scans. */
struct PtxScan {
  /** \brief Numbers of columns and rows of points. */
  std::uint64_t columns = 0, rows = 0;
  /** \brief Position of the scanner in the common frame. */
  Eigen::Vector3d position;
  /** \brief The axes of the scanner in the common frame, as columns. */
  Eigen::Matrix3d axes;
  /** \brief Transform from the frame of the scan to the common frame. */
  Eigen::Affine3d transform;
};

/** \brief Reads a PTX: scans one after the other, each a header of ten lines and a line
 * for each point. */
class PtxReader {
public:
  explicit PtxReader (const std::string& file) : reader_ (file, "PTX"), rows_ (reader_)
  {
    reader_.skipByteOrderMark();
  }

  FileCloud
  read ()
  {
    FileCloud cloud;
    PtxScan scan; // the last one that was read
    while (reader_.nextWords()) {
      scan = readScanHeader();
      cloud.scans.push_back ({rows_.size(), scan.position});
      readPoints (scan);
    }
    cloud.points = rows_.take();
    if (cloud.scans.size() > 1)
      return cloud;
    cloud.scans.clear();
    // A PTX has its points column by column, a cloud row by row: so a column of the
    // scan is a row of the cloud.
    cloud.points.width = static_cast<pcl::uindex_t> (scan.rows);
    cloud.points.height = static_cast<pcl::uindex_t> (scan.columns);
    cloud.origin = scan.position;
    cloud.orientation = scan.axes;
    return cloud;
  }

private:
  /** \brief Returns the only number of the current line, a count.
   * \param[in] what the count, for messages */
  std::uint64_t
  countInLine (const std::string& what)
  {
    reader_.expectWordCount (1);
    return reader_.parseCount (what, std::string (reader_.word (0)));
  }

  /** \throws WorkError if there is no further line */
  void
  nextLine ()
  {
    if (!reader_.nextWords())
      reader_.failTruncated();
  }

  /** \brief Reads the next line, a vector of finite numbers. */
  template <int size>
  Eigen::Matrix<double, size, 1>
  nextVector ()
  {
    nextLine();
    reader_.expectWordCount (size);
    Eigen::Matrix<double, size, 1> vector;
    for (int i = 0; i < size; ++i)
      vector[i] = reader_.number (static_cast<std::size_t> (i));
    if (!vector.allFinite())
      reader_.failAtLine ("has a pose that is not finite");
    return vector;
  }

  /** \brief Reads the header of a scan; its first line, the number of columns, is the
   * current one. */
  PtxScan
  readScanHeader ()
  {
    // Orthonormal axes have a determinant of 1 or -1, but axes may be rounded.
    constexpr double min_determinant = 0.5;
    PtxScan scan;
    scan.columns = countInLine ("its number of columns");
    nextLine();
    scan.rows = countInLine ("its number of rows");
    scan.position = nextVector<3>();
    for (int axis = 0; axis < 3; ++axis)
      scan.axes.col (axis) = nextVector<3>();
    if (std::abs (scan.axes.determinant()) < min_determinant)
      reader_.failAtLine ("ends the axes of a scanner, which are no three directions");
    // PTX multiplies a row vector by the matrix, so its rows are columns here.
    for (int row = 0; row < 4; ++row)
      scan.transform.matrix().col (row) = nextVector<4>();
    if (scan.transform.matrix().row (3) != Eigen::RowVector4d (0.0, 0.0, 0.0, 1.0))
      reader_.failAtLine ("ends a matrix that is no rotation and translation");
    if (scan.position.isZero (0.0)) // some writers set only the matrix
      scan.position = scan.transform.translation();
    return scan;
  }

  /** \brief Declares the columns of the current line: x, y, z, then perhaps the
   * intensity, then perhaps a color. */
  void
  declareColumns ()
  {
    const std::size_t columns = reader_.wordCount();
    const bool has_intensity = columns == 4 || columns == 7;
    const bool has_color = columns == 6 || columns == 7;
    if (columns != 3 && !has_intensity && !has_color)
      reader_.failAtLine ("has " + std::to_string (columns) +
                          " numbers instead of 3, 4, 6 or 7");
    for (const char* coordinate : {"x", "y", "z"})
      rows_.addColumn (coordinate, PCLPointField::FLOAT64);
    if (has_intensity)
      rows_.addColumn ("intensity", PCLPointField::FLOAT32);
    if (has_color)
      rows_.addColor();
  }

  /** \brief Reads the points of a scan, a line for each. */
  void
  readPoints (const PtxScan& scan)
  {
    for (std::uint64_t i = 0; i < scan.columns * scan.rows; ++i) {
      nextLine();
      if (!rows_.hasColumns())
        declareColumns();
      rows_.addPoint();
      moveLastPoint (scan.transform);
    }
  }

  /** \brief Transforms the last point into the common frame. A point at the scanner is
   * a missing reading and becomes NaN. */
  void
  moveLastPoint (const Eigen::Affine3d& transform)
  {
    Eigen::Vector3d position;
    std::uint8_t* const point = rows_.lastPoint();
    std::memcpy (position.data(), point, sizeof (position));
    if (position.isZero (0.0))
      position.setConstant (std::numeric_limits<double>::quiet_NaN());
    position = transform * position;
    std::memcpy (point, position.data(), sizeof (position));
  }

  FileReader reader_;
  PointRows rows_;
};

} // namespace

FileCloud
readPtx (const std::string& file)
{
  return PtxReader (file).read();
}

} // namespace pcl_ops::apps
