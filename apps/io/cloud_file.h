// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/PCLPointCloud2.h>

#include <Eigen/Geometry>

#include "number_types.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace pcl_ops::apps {

class LasFile;

/** \brief The files of \ref loadCloud, for messages. */
inline constexpr const char* cloud_file_kinds =
    "a .pcd, .ply, .las, .xyz, .txt, .pts or .csv file";

/** \brief A cloud as its file has it: every field, and where the sensor stood. */
struct FileCloud {
  pcl::PCLPointCloud2 points;
  /** \brief The sensor's pose in the frame of the points: zero and identity where the
   * file has none or an invalid one, and for PLY. */
  Eigen::Vector4f origin = Eigen::Vector4f::Zero();
  Eigen::Quaternionf orientation = Eigen::Quaternionf::Identity();
  /** \brief Where the cloud is from a LAS: what has all its other bytes, too. */
  std::shared_ptr<LasFile> las = {};
  /** \brief From a LAS or a text, which do not know where a sensor stood. */
  bool is_survey = false;

  std::size_t
  size () const
  {
    return static_cast<std::size_t> (points.width) * points.height;
  }
};

/** \brief Whether a file is taken for a cloud because it lies in a folder of them: it
 * is one of \ref cloud_file_kinds, or a .laz where LASzip is, but not .txt or .csv,
 * which mostly are something else there. */
bool
isCloudFile (const std::string& file);

/** \brief Whether a file is called like one of \ref cloud_file_kinds, or .laz. */
bool
hasCloudExtension (const std::string& file);

/** \brief Those of \ref isCloudFile, for messages. */
inline constexpr const char* folder_extensions = ".pcd, .ply, .las, .xyz or .pts";

/** \brief Reads a .pcd (ascii, binary, binary_compressed), .ply, .las or text file, and
 * .laz where LASzip is. The readers are
 * our own: PCL's crash on broken headers, and are in a library that loads VTK and more.
 * \throws UsageError for another extension, WorkError if the file is missing, a folder,
 * compressed as a whole, malformed, truncated or without points, or has no x, y and z
 */
FileCloud
loadCloud (const std::string& file);

/** \brief Opens a .las file, whose points are read later. Those of a .laz are put into
 * a file for temporary ones ($TMPDIR) first, which has no name while it is open.
 * \throws WorkError as \ref loadCloud */
std::shared_ptr<LasFile>
openLas (const std::string& file);

/** \brief A cloud of so many points, whose bytes are to come, with the fields and the
 * sensor of another. */
FileCloud
emptyLike (const FileCloud& cloud, std::size_t size);

/** \brief Sets fields of a part of a cloud: of its points from \p first on, none of
 * them for the header of a file. */
using SetFields = std::function<void (FileCloud& part, std::size_t first)>;

/** \brief Writes a .ply (\ref plyHeader), or a binary PCD, in one step (\ref
 * writeFile).
 * \param[in] set_fields changes what is written, part after part: the cloud stays as it
 * is, and large ones need no room for another
 * \throws WorkError if it cannot be written */
void
saveCloud (const std::string& file,
           const FileCloud& cloud,
           const SetFields& set_fields = {});

/** \brief What stands for the standard streams where a file name is expected. */
inline constexpr const char* standard_stream = "-";

/** \brief How the standard input is called in messages. */
inline constexpr const char* standard_input = "standard input";

/** \brief Reads the PCD (ascii, binary, binary_compressed), PLY, LAS or text that is
 * piped into the program; a text by its first number or //. PCL reads from files only:
 * all of it is put into one for temporary files ($TMPDIR) first, which is removed in
 * any case. \throws UsageError if nothing is piped in, WorkError as \ref loadCloud, and
 * Interrupted */
FileCloud
loadStandardInput ();

/** \brief The number of points. */
inline std::size_t
sizeOf (const pcl::PCLPointCloud2& points)
{
  return static_cast<std::size_t> (points.width) * points.height;
}

/** \brief Declares a field behind those that a point has.
 * \param[in] datatype as in pcl::PCLPointField */
void
addField (const std::string& name,
          std::uint8_t datatype,
          pcl::PCLPointCloud2& points,
          pcl::uindex_t count = 1);

/** \brief Whether the cloud has a field of that name. */
bool
hasField (const FileCloud& cloud, const std::string& name);

/** \brief Sets a field of four bytes of every point: in place of the one of its name,
 * which reaches to the next one, else before the one called \p before, else at the end.
 * \param[in] values four bytes for each point */
void
setField (FileCloud& cloud,
          const std::string& name,
          std::uint8_t datatype,
          const void* values,
          const std::string& before = "");

} // namespace pcl_ops::apps
