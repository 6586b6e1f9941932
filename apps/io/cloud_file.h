// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/PCLPointCloud2.h>

#include <Eigen/Geometry>

#include "number_types.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace pcl_ops::apps {

struct LasFile;

/** \brief One of several scans in a file. The points of a scan follow one another in
 * the cloud and end where the next scan begins. */
struct Scan {
  /** \brief Index in the cloud of the first point of the scan. */
  std::size_t first;
  /** \brief Where the scanner stood, in the common frame of all scans. */
  Eigen::Vector3d position;
};

/** \brief Lists the extensions of \ref loadCloud for messages: "a .pcd, ... or .obj
 * file". */
std::string
cloudFileKinds ();

/** \brief Returns the number of points. */
inline std::size_t
sizeOf (const pcl::PCLPointCloud2& points)
{
  return static_cast<std::size_t> (points.width) * points.height;
}

/** \brief A cloud with every field of its file, and the sensor's pose. */
struct FileCloud {
  pcl::PCLPointCloud2 points;
  /** \brief Position of the sensor in the frame of the points; zero where the file has
   * no valid one. The pose in a PLY is not read. */
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  /** \brief Rotation from the frame of the sensor to that of the points; the identity
   * where the file has no valid one. */
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  /** \brief The open LAS file that the points come from: it has all attributes, \ref
   * points only some. nullptr for other formats. */
  std::shared_ptr<LasFile> las = {};
  /** \brief Whether the format is LAS, text, OFF or OBJ. Files of these formats have no
   * pose, and \ref origin need not be the position of a sensor. */
  bool is_survey = false;
  /** \brief The scans of a PTX that has two or more, in the order of their points; then
   * \ref origin and \ref orientation keep their defaults. Else empty. */
  std::vector<Scan> scans = {};

  /** \brief Returns the number of points. */
  std::size_t
  size () const
  {
    return sizeOf (points);
  }
};

/** \brief Whether \ref loadCloud knows the extension of a file, even if only to refuse
 * it, as .e57, or .laz without LASzip. */
bool
hasCloudExtension (const std::string& file);

/** \brief Whether a file in a folder is taken for a cloud, by its extension. False for
 * .txt, .csv, .npy and meshes, as in a folder these mostly hold something else, and for
 * formats that are refused, as .laz without LASzip. */
bool
isCloudFile (const std::string& file);

/** \brief Lists the extensions of \ref isCloudFile that every build reads, so not .laz,
 * for messages: ".pcd, .ply, ... or .bin". */
std::string
folderExtensions ();

/** \brief Reads a cloud; a .laz only if the build has LASzip. cloud_file.cpp lists all
 * formats, the same for programs and Python. The readers do not use PCL's, which crash
 * on broken headers and are in a library that loads VTK and more.
 * \throws UsageError for another extension, WorkError if the file is missing, a folder,
 * gzip, of a refused format, malformed, truncated or without points, or has no x, y and
 * z */
FileCloud
loadCloud (const std::string& file);

/** \brief Returns an unorganized cloud with the fields and the pose of another cloud,
 * for an output: the other members have their defaults. The width is \p size, but the
 * data are empty: the caller adds them. */
FileCloud
emptyLike (const FileCloud& cloud, std::size_t size);

/** \brief Sets or changes fields of \p part, a copy of consecutive points of a cloud,
 * of which the first one has the index \p first there. Also called with a part without
 * points, whose fields tell the header of the file. */
using SetFields = std::function<void (FileCloud& part, std::size_t first)>;

/** \brief Writes a .ply (\ref plyHeader), or for any other extension a binary PCD, by
 * \ref writeFile.
 * \param[in] set_fields changes what is written, block by block, so that a large cloud
 * is never copied as a whole */
void
saveCloud (const std::string& file,
           const FileCloud& cloud,
           const SetFields& set_fields = {});

/** \brief The file name that stands for the standard input or output. */
inline constexpr const char* standard_stream = "-";

/** \brief The name of the standard input in messages. */
inline constexpr const char* standard_input = "standard input";

/** \brief Reads the cloud that is piped into the program, by way of a temporary file
 * ($TMPDIR). The first bytes tell the format; text that begins like no other format is
 * read as .xyz. A KITTI .bin or an .obj cannot be recognized.
 * \throws UsageError if nothing is piped in, WorkError as \ref loadCloud, Interrupted
 */
FileCloud
loadStandardInput ();

/** \brief Declares a field behind the others and enlarges point_step. The data do not
 * change.
 * \param[in] datatype a type of pcl::PCLPointField
 * \param[in] count number of values of the field in each point */
void
addField (const std::string& name,
          std::uint8_t datatype,
          pcl::PCLPointCloud2& points,
          pcl::uindex_t count = 1);

bool
hasField (const FileCloud& cloud, const std::string& name);

/** \brief Sets a field of four bytes of every point. A field with the same name is
 * replaced, together with any padding up to the next field. If no field has the name,
 * the new field goes in front of the field called \p before, or to the end if there is
 * no such field either. The fields must be in the order of their offsets.
 * \param[in] datatype a type of pcl::PCLPointField
 * \param[in] values four bytes for each point */
void
setField (FileCloud& cloud,
          const std::string& name,
          std::uint8_t datatype,
          const void* values,
          const std::string& before = "");

} // namespace pcl_ops::apps
