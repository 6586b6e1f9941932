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

/** \brief Returns the four bytes of a field, e.g. the label, of the next point. Called
 * once for each point, in the order of the points.
 * \param[in] position of the point */
using NextFieldValue = std::function<std::uint32_t (const Eigen::Vector3d& position)>;

/** \brief Called with the position and the label of a point. */
using VisitLabeledPosition =
    std::function<void (const Eigen::Vector3d& position, std::uint32_t label)>;

/** \brief A field of extra bytes to be written, and its values for all points. */
struct LasColumn {
  LasField field;
  NextFieldValue next_value;
};

/** \brief A LAS file, versions 1.0 to 1.4. The file stays open, so that attributes
 * other than coordinates can be copied later and need no memory. It may be removed from
 * its folder meanwhile. */
struct LasFile {
  /** \param[in] name_in_messages of the file that was decompressed into \p file; empty
   * if \p file was not made by decompression
   * \throws WorkError if \p file is no LAS file, a variable length record does not fit
   * before the points, or the Extra Bytes VLR describes more bytes than a record has */
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

  /** \brief Checks the points and the extended VLRs behind them. If one of these
   * describes the extra bytes, sets \ref has_extra_bytes_evlr, \ref fields and
   * \ref fields_end.
   * \throws WorkError as \ref checkCount, or if the file does not hold its
   * uncompressed points, or valid extended variable length records behind them */
  void
  checkPoints ();

  /** \brief Sets \ref fields to those that an Extra Bytes VLR describes.
   * \throws WorkError if they have more bytes than a record */
  void
  readFields (const LasVlr& vlr);

  // Call checkPoints before readPoints, position, forPositions and forLabels, which
  // read uncompressed points, and before validate, which needs the fields of all
  // records.

  /** \brief Returns all points with x, y, z in double precision, intensity in single
   * precision, and label, if the file has a \ref label_field. */
  pcl::PCLPointCloud2
  readPoints ();

  /** \brief Returns the coordinates of a point.
   * \param[in] point index in the file, from 0 */
  Eigen::Vector3d
  position (std::uint64_t point);

  /** \brief Calls \p visit with the position of every point, in the order of the
   * points. Only a block of points is in memory at a time. */
  void
  forPositions (const std::function<void (const Eigen::Vector3d&)>& visit);

  /** \brief Does the same as \ref forPositions with the label of every point, too.
   * \throws WorkError if the file has no labels */
  void
  forLabels (const VisitLabeledPosition& visit);

  /** \brief Checks whether a copy of the file can have the wanted fields, too.
   * \return why it cannot, and the fix; empty if it can */
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

  /** \brief Sets the offsets in the header of a copy of this file, and writes the
   * header to the beginning of \p front.
   * \param[in] copy_header its offsets are still those of this file
   * \param[in] points_end, copy_points_end offsets of the end of the points in this
   * file and in the copy
   * \param[in,out] front all bytes of the copy in front of its points, with any bytes
   * in place of the header */
  void
  replaceHeader (LasHeader copy_header,
                 std::uint64_t points_end,
                 std::uint64_t copy_points_end,
                 std::string& front) const;

  /** \brief Writes the bytes of the file from the offset \p begin on. */
  void
  copyFrom (std::uint64_t begin, std::ostream& stream);

  /** \brief The name of the file in messages. */
  std::string file;
  FileReader reader;
  LasHeader header;
  /** \brief LasHeader::scale and LasHeader::offset: along each axis a coordinate is
   * raw * scale + offset. */
  Eigen::Vector3d coordinate_scale, coordinate_offset;
  /** \brief Offset in the file of the end of the last VLR [bytes]. */
  std::uint64_t vlrs_end;
  /** \brief The VLR that describes the extra bytes of a record. */
  std::optional<LasVlr> extra_bytes;
  /** \brief The VLR that describes how points are compressed. */
  std::optional<LasVlr> laszip;
  /** \brief The VLRs with the reference system, as WKT and as GeoTIFF keys; the last
   * one of each kind, if there are several. */
  std::optional<LasVlr> wkt, geo_keys;
  /** \brief Whether an extended VLR, which follows the points, describes the extra
   * bytes. Then \ref extra_bytes is not set. Is set by \ref checkPoints. */
  bool has_extra_bytes_evlr = false;
  /** \brief The fields that the Extra Bytes VLR, or the extended one, describes. */
  std::vector<LasField> fields;
  /** \brief Offset in a record of the end of these fields [bytes]; without fields the
   * end of the attributes that the point format has. */
  std::uint64_t fields_end;
  /** \brief The point records that \ref position read last, one after the other. */
  std::string block;
  /** \brief Index in the file of the first point of \ref block, and the number of
   * points of \ref block. */
  std::uint64_t first_in_block = 0, points_in_block = 0;
};

/** \brief Whether the extension is .las or .laz. */
bool
isLasName (const std::string& file);

/** \brief Opens a .las, whose points are read later. A .laz is decompressed into a
 * temporary file ($TMPDIR) first. This file is removed from its folder at once, but
 * stays readable while the returned object exists.
 * \throws WorkError as \ref loadCloud */
std::shared_ptr<LasFile>
openLas (const std::string& file);

/** \brief Writes a copy of \p las with further fields by \ref writeFile; compressed if
 * \p file is a .laz. A field replaces one of the same name and type; all other data are
 * kept.
 * \param[in] columns with fields that LasFile::validate allows
 * \throws WorkError as \ref writeFile, or if \p file is a .laz and this build has no
 * LASzip, or if the file of \p las has become shorter since it was opened */
void
saveLasWith (const std::string& file,
             LasFile& las,
             const std::vector<LasColumn>& columns);

/** \brief Calls \ref saveLasWith with the fields label, distance and plane.
 * \param[in] labels one for each point
 * \param[in] distances, planes one for each point; empty: no such field */
void
saveLabeledLas (const std::string& file,
                LasFile& las,
                const std::vector<std::uint32_t>& labels,
                const std::vector<float>& distances = {},
                const std::vector<std::uint32_t>& planes = {});

/** \brief A record of point data record format 0, and a label as extra bytes. The
 * records of all formats begin with the raw coordinates and the intensity. */
struct LasPoint {
  /** \brief For x, y and z: a coordinate is raw * LasHeader::scale + LasHeader::offset.
   */
  std::array<boost::endian::little_int32_t, 3> raw{};
  LasHeader::UInt16 intensity = 0;
  /** \brief The other attributes of the format: number of the return, class and the
   * like.
   */
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

/** \brief Writes the LAS from which the LAZ \p file was made, the same in each byte.
 * \throws WorkError if the file is damaged or this build has no LASzip, Interrupted */
void
decompressLaz (const std::string& file, std::ostream& stream);

/** \brief Writes a LAZ: the LAS \p file with compressed points and a VLR on these. All
 * other data are kept.
 * \param[in] stream at its beginning; must be seekable, as the header is written once
 * more after the points
 * \throws WorkError as \ref decompressLaz, Interrupted */
void
compressLas (const std::string& file, std::ostream& stream);

} // namespace pcl_ops::apps
