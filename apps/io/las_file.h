// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/PCLPointCloud2.h>

#include "las_header.h"

#include <array>
#include <functional>
#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief Returns the four bytes of a field, e.g. the label, of the next point, given
 * its position. It is called once for each point, in their order. */
using NextFieldValue = std::function<std::uint32_t (const Eigen::Vector3d& position)>;

/** \brief Called with the position and the label of a point. */
using VisitLabeledPosition =
    std::function<void (const Eigen::Vector3d& position, std::uint32_t label)>;

/** \brief A field of extra bytes, and its values for all points. */
struct LasColumn {
  LasField field;
  NextFieldValue next_value;
};

/** \brief A LAS file, versions 1.0 to 1.4. It stays open, so that attributes other than
 * coordinates can be copied later and need no memory. The file may be removed
 * meanwhile. */
struct LasFile {
  /** \throws WorkError if it is no LAS file, a variable length record does not fit
   * before the points, or the Extra Bytes VLR describes more bytes than a record has
   * \param[in] name_in_messages of the file that was decompressed into this one; empty
   * for none */
  explicit LasFile (const std::string& file, const std::string& name_in_messages = "");

  /** \brief Number of points. */
  std::uint64_t
  size () const
  {
    return header.pointCount();
  }

  /** \brief Whether the points are compressed (LAZ), whatever the extension. */
  bool
  isCompressed () const
  {
    return header.format_bits != header.pointFormat() || laszip;
  }

  /** \throws WorkError if the file has no points, or more than PCL's indices can number
   */
  void
  checkCount () const;

  /** \throws WorkError as \ref checkCount, or if the file does not hold its
   * uncompressed points, or valid extended variable length records behind them */
  void
  checkPoints ();

  /** \brief Sets the fields to those that an Extra Bytes VLR describes.
   * \throws WorkError if it describes more bytes than a record has */
  void
  readFields (const LasVlr& vlr);

  /** \brief Returns all points with x, y, z in double precision, intensity in single
   * precision, and label, if the file has a \ref label_field. Call \ref checkPoints
   * before this and the following functions that read points. */
  pcl::PCLPointCloud2
  readPoints ();

  /** \param[in] point index in the file, from 0 */
  Eigen::Vector3d
  position (std::uint64_t point);

  /** \brief Calls \p visit with the position of every point, in their order. Only a
   * block of points is in memory at a time. */
  void
  forPositions (const std::function<void (const Eigen::Vector3d&)>& visit);

  /** \brief Calls \p visit with the position and the label of every point, as
   * \ref forPositions.
   * \throws WorkError if the file has no labels */
  void
  forLabels (const VisitLabeledPosition& visit);

  /** \brief Checks whether a copy of the file can have these fields, too.
   * \return why not, and the fix; empty if it can */
  std::string
  validate (const std::vector<LasField>& wanted) const;

  /** \brief Returns the bytes of the file from the offset \p begin up to \p end. */
  std::string
  bytes (std::uint64_t begin, std::uint64_t end)
  {
    std::string bytes (end - begin, '\0');
    reader.goTo (begin);
    reader.read (bytes.data(), bytes.size());
    return bytes;
  }

  /** \brief Completes the header of a copy of this file, and writes it over the header
   * that \p front begins with.
   * \param[in] copy the header; its offsets are still those of this file
   * \param[in] points_end, copy_points_end offsets of the end of the points in this file
   * and in the copy
   * \param[in,out] front all bytes of the copy in front of its points */
  void
  replaceHeader (LasHeader copy,
                 std::uint64_t points_end,
                 std::uint64_t copy_points_end,
                 std::string& front) const;

  /** \brief Writes the bytes from the offset \p begin up to the end of the file. */
  void
  copyFrom (std::uint64_t begin, std::ostream& stream);

  /** \brief The name of the file in messages. */
  std::string file;
  FileReader reader;
  LasHeader header;
  /** \brief Those of the header. */
  Eigen::Vector3d scale, offset;
  /** \brief Offset of the end of the last VLR in the file [bytes]. */
  std::uint64_t vlrs_end;
  /** \brief The VLRs that describe the extra bytes of a record, and compressed points.
   */
  std::optional<LasVlr> extra_bytes, laszip;
  /** \brief The VLRs with the reference system as WKT and as GeoTIFF keys; the last one
   * of each kind counts. */
  std::optional<LasVlr> wkt, geo_keys;
  /** \brief Whether the Extra Bytes VLR is an extended one, which follows the points;
   * known from \ref checkPoints on. Then \ref extra_bytes is not set. */
  bool describes_behind_points = false;
  /** \brief The fields that the Extra Bytes VLR describes. */
  std::vector<LasField> fields;
  /** \brief Offset of the end of these fields in a record [bytes]. */
  std::uint64_t fields_end;
  /** \brief The records that \ref position read last. */
  std::string block;
  /** \brief Index of the first point in \ref block, and the number of points there. */
  std::uint64_t first_in_block = 0, points_in_block = 0;
};

bool
isLasName (const std::string& file);

/** \brief Opens a .las, whose points are read later. A .laz is decompressed into a
 * temporary file ($TMPDIR) first, which is unlinked while it is open.
 * \throws WorkError as \ref loadCloud */
std::shared_ptr<LasFile>
openLas (const std::string& file);

/** \brief Writes a copy of \p las with further fields by \ref writeFile; compressed if
 * \p file is a .laz. A field replaces one of the same name and type; all other data are
 * kept.
 * \param[in] columns with fields that LasFile::validate allows
 * \throws WorkError if the file of \p las was cut meanwhile */
void
saveLasWith (const std::string& file,
             LasFile& las,
             const std::vector<LasColumn>& columns);

/** \brief Calls \ref saveLasWith with a label and, unless these are empty, a distance
 * and a plane for each point. */
void
saveLabeledLas (const std::string& file,
                LasFile& las,
                const std::vector<std::uint32_t>& labels,
                const std::vector<float>& distances = {},
                const std::vector<std::uint32_t>& planes = {});

/** \brief A record of point data record format 0 with a label. All formats begin with
 * the raw coordinates and the intensity. */
struct LasPoint {
  /** \brief Coordinates are raw * LasHeader::scale + LasHeader::offset. */
  std::array<boost::endian::little_int32_t, 3> raw{};
  LasHeader::UInt16 intensity = 0;
  /** \brief Number of the return, class and the like. */
  std::array<char, 6> others{};
  LasHeader::UInt32 label = 0;
};
static_assert (sizeof (LasPoint) == 24, "without padding");

/** \brief Writes a LAS 1.2 of point data record format 0 by \ref writeFile, with the
 * labels as extra bytes.
 * \param[in] points at least one
 * \param[in] scale [m], the same for each axis
 * \param[in] offset [m] */
void
saveLas (const std::string& file,
         const std::vector<LasPoint>& points,
         double scale,
         const Eigen::Vector3d& offset);

/** \brief Whether this build has LASzip. */
bool
hasLaszip ();

// These two throw a WorkError if the file is damaged or LASzip is missing, and
// Interrupted.

/** \brief Writes the LAS that the LAZ \p file was made from, byte by byte the same. */
void
decompressLaz (const std::string& file, std::ostream& stream);

/** \brief Writes the LAS \p file with compressed points; all other data are kept.
 * \param[in] stream at its beginning; it must be seekable, as the header is written
 * again at last */
void
compressLas (const std::string& file, std::ostream& stream);

} // namespace pcl_ops::apps
