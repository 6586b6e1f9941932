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
#include <utility>
#include <vector>

namespace pcl_ops::apps {

/** \brief Returns the label of the next point, given its coordinates. It is called once
 * for each point, in their order. */
using LabelOfPlace = std::function<std::uint32_t (const Eigen::Vector3d&)>;

/** \brief Called with the coordinates and the label of a point. */
using VisitLabelled = std::function<void (const Eigen::Vector3d&, std::uint32_t)>;

/** \brief A field of extra bytes, and the function that returns its four bytes for the
 * next point. */
using LasColumn = std::pair<LasField, LabelOfPlace>;

/** \brief A LAS file, versions 1.0 to 1.4. It stays open, so that attributes other than
 * coordinates can be copied later and need no memory. The file may be removed
 * meanwhile. */
struct LasFile {
  /** \throws WorkError if it is no LAS file, a variable length record does not fit
   * before the points, or the Extra Bytes VLR describes more bytes than a record has */
  explicit LasFile (const std::string& file);

  std::uint64_t
  size () const
  {
    return header.pointCount();
  }

  /** \brief Whether the points are compressed (LAZ), whatever the extension. */
  bool
  isCompressed () const
  {
    return header.format != header.pointFormat() || laszip;
  }

  /** \throws WorkError if the file has no points, or more than PCL's indices can tell
   * apart */
  void
  checkCount () const;

  /** \throws WorkError as \ref checkCount, or if the file does not hold its
   * uncompressed points, or valid extended variable length records behind them */
  void
  checkPoints ();

  /** \brief Returns all points with x, y, z in double precision, intensity, and, if the
   * file has it, label. */
  pcl::PCLPointCloud2
  readPoints ();

  Eigen::Vector3d
  place (std::uint64_t point);

  /** \brief Calls \p visit with the coordinates of every point. Only a block of points
   * is in memory at a time. */
  void
  forPlaces (const std::function<void (const Eigen::Vector3d&)>& visit);

  /** \brief Calls \p visit with the coordinates and the label of every point, as
   * \ref forPlaces.
   * \throws WorkError if the file has no labels */
  void
  forLabels (const VisitLabelled& visit);

  /** \brief Returns why the fields cannot be added to the others, and the fix; empty if
   * they can. */
  std::string
  validate (const std::vector<LasField>& wanted) const;

  std::string
  bytes (std::uint64_t begin, std::uint64_t end)
  {
    std::string bytes (end - begin, '\0');
    reader.goTo (begin);
    reader.read (bytes.data(), bytes.size());
    return bytes;
  }

  /** \brief Writes the header of a copy into \p front, the bytes of the copy before its
   * points, with the offsets to the points and to all that follows them.
   * \param[in] points_end, copy_points_end where the points end in the file and in the
   * copy */
  void
  putHeader (LasHeader copy,
             std::uint64_t points_end,
             std::uint64_t copy_points_end,
             std::string& front) const;

  void
  copyRest (std::uint64_t begin, std::ostream& stream);

  std::string file;
  HeaderReader reader;
  LasHeader header;
  Eigen::Vector3d scale, offset;
  std::uint64_t vlrs_end;
  /** \brief The VLRs that describe the extra bytes of a record, and compressed points.
   */
  std::optional<LasVlr> extra_bytes, laszip;
  /** \brief The VLRs with the reference system as WKT and as GeoTIFF keys; the last one
   * of each kind counts. */
  std::optional<LasVlr> wkt, geo_keys;
  /** \brief The fields that the Extra Bytes VLR describes, and where they end in a
   * record. */
  std::vector<LasField> fields;
  std::uint64_t fields_end;
  /** \brief The records that \ref place read last. */
  std::string block;
  std::uint64_t first_in_block = 0, points_in_block = 0;
};

bool
isLasName (const std::string& file);

/** \brief Opens a .las, whose points are read later. A .laz is decompressed into a
 * temporary file ($TMPDIR) first, which is unlinked while it is open.
 * \throws WorkError as \ref loadCloud */
std::shared_ptr<LasFile>
openLas (const std::string& file);

/** \brief Writes every byte of a file, with further fields, by \ref writeFile;
 * compressed if \p file is a .laz. A field replaces one of the same name and type.
 * \throws WorkError if the file was cut meanwhile */
void
saveLasWith (const std::string& file,
             LasFile& las,
             const std::vector<LasColumn>& columns);

/** \brief Calls \ref saveLasWith with a label and, unless these are empty, a distance
 * and a plane for each point. */
void
saveLabelledLas (const std::string& file,
                 LasFile& las,
                 const std::vector<std::uint32_t>& labels,
                 const std::vector<float>& distances = {},
                 const std::vector<std::uint32_t>& planes = {});

/** \brief A record of point data record format 0 with a label. Its beginning, the raw
 * coordinates and the intensity, is that of all formats. Coordinates are raw * scale +
 * offset. */
struct LasPoint {
  std::array<boost::endian::little_int32_t, 3> raw{};
  LasHeader::Short intensity = 0;
  std::array<char, 6> others{};
  LasHeader::Long label = 0;
};
static_assert (sizeof (LasPoint) == 24, "without padding");

/** \brief Writes a LAS 1.2 of point data record format 0 by \ref writeFile, with the
 * labels as extra bytes. */
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

/** \brief Writes the LAS that a LAZ was made from, byte by byte the same. */
void
decompressLaz (const std::string& file, std::ostream& stream);

/** \brief Writes a LAS with compressed points; every other byte is kept. */
void
compressLas (const std::string& file, std::ostream& stream);

} // namespace pcl_ops::apps
