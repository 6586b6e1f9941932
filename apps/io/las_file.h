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

/** \brief Of the next point, given where that is. */
using LabelOfPlace = std::function<std::uint32_t (const Eigen::Vector3d&)>;

/** \brief Called with the place and the label of a point. */
using VisitLabelled = std::function<void (const Eigen::Vector3d&, std::uint32_t)>;

/** \brief A field of extra bytes, and its four of the next point. */
using LasColumn = std::pair<LasField, LabelOfPlace>;

/** \brief A LAS file, versions 1.0 to 1.4. It stays open, so that what is no coordinate
 * need not be in memory to be written again, and may be removed meanwhile. */
struct LasFile {
  /** \throws WorkError if it is none, a variable length record does not fit in front of
   * the points, or they describe more extra bytes than there are */
  explicit LasFile (const std::string& file);

  std::uint64_t
  size () const
  {
    return header.pointCount();
  }

  /** \brief Whether its points are, whatever it is called. */
  bool
  isCompressed () const
  {
    return header.format != header.pointFormat() || laszip;
  }

  /** \throws WorkError if the file has no points, or more than PCL's indices can tell
   * apart */
  void
  checkCount () const;

  /** \throws WorkError as \ref checkCount, or if the file does not hold the points,
   * which are not compressed, and what is behind them */
  void
  checkPoints ();

  /** \brief With x, y, z in double precision, intensity, and label if there is one. */
  pcl::PCLPointCloud2
  readPoints ();

  Eigen::Vector3d
  place (std::uint64_t point);

  /** \brief Visits the places of all points, with a block of them in memory. */
  void
  forPlaces (const std::function<void (const Eigen::Vector3d&)>& visit);

  /** \brief Visits the places of all points with their labels, as \ref forPlaces.
   * \throws WorkError if they have none */
  void
  forLabels (const VisitLabelled& visit);

  /** \brief Why there can be no such fields beside all else, with the fix, or empty. */
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

  /** \brief Lets the front of a copy say where its points and all behind them are.
   * \param[in] points_end, copy_points_end where they end in the file and in the copy */
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
  /** \brief What describes the extra bytes of a record, and compressed points. */
  std::optional<LasVlr> extra_bytes, laszip;
  /** \brief The reference system as text and as keys of GeoTIFF; of several the last.
   */
  std::optional<LasVlr> wkt, geo_keys;
  /** \brief The extra bytes that are described, and where they end in a record. */
  std::vector<LasField> fields;
  std::uint64_t fields_end;
  /** \brief Records that \ref place read last. */
  std::string block;
  std::uint64_t first_in_block = 0, points_in_block = 0;
};

bool
isLasName (const std::string& file);

/** \brief Opens a .las, whose points are read later; those of a .laz are put into a
 * temporary file ($TMPDIR) first, which has no name while it is open.
 * \throws WorkError as \ref loadCloud */
std::shared_ptr<LasFile>
openLas (const std::string& file);

/** \brief Writes every byte of a file with further fields, each in place of the one of
 * its name that there is, by \ref writeFile. \throws WorkError if the file was cut
 * meanwhile */
void
saveLasWith (const std::string& file,
             LasFile& las,
             const std::vector<LasColumn>& columns);

/** \brief The same with a label and, unless there are none, a distance and a plane per
 * point. */
void
saveLabelledLas (const std::string& file,
                 LasFile& las,
                 const std::vector<std::uint32_t>& labels,
                 const std::vector<float>& distances = {},
                 const std::vector<std::uint32_t>& planes = {});

/** \brief A record of point data record format 0 with a label: a point in units of the
 * scale, relative to the offset, with which those of all formats begin. */
struct LasPoint {
  std::array<boost::endian::little_int32_t, 3> raw{};
  LasHeader::Short intensity = 0;
  std::array<char, 6> others{};
  LasHeader::Long label = 0;
};
static_assert (sizeof (LasPoint) == 24, "without padding");

/** \brief Writes a LAS 1.2 of point data record format 0 by \ref writeFile, with the
 * labels in its extra bytes. */
void
saveLas (const std::string& file,
         const std::vector<LasPoint>& points,
         double scale,
         const Eigen::Vector3d& offset);

/** \brief Whether LASzip was there when this was built. */
bool
hasLaszip ();

// Both throw a WorkError if the file is damaged or LASzip is missing, and Interrupted.

/** \brief Writes the LAS that was compressed, to the byte. */
void
decompressLaz (const std::string& file, std::ostream& stream);

/** \brief Writes a LAS with compressed points and every other byte kept. */
void
compressLas (const std::string& file, std::ostream& stream);

} // namespace pcl_ops::apps
