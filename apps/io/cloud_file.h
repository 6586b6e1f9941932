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

/** \brief One of several in a file, of the points from its \p first on. */
struct Scan {
  std::size_t first;
  /** \brief Where it was taken from, in the frame of all. */
  Eigen::Vector3d place;
};

/** \brief The files of \ref loadCloud, for messages: "a .pcd, ... or .obj file". */
std::string
cloudFileKinds ();

inline std::size_t
sizeOf (const pcl::PCLPointCloud2& points)
{
  return static_cast<std::size_t> (points.width) * points.height;
}

/** \brief A cloud as its file has it: every field, and the sensor's pose in their
 * frame: zero and identity where the file has none or an invalid one, and for PLY. */
struct FileCloud {
  pcl::PCLPointCloud2 points;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  /** \brief Of a cloud from a LAS: what has all its other bytes, too. */
  std::shared_ptr<LasFile> las = {};
  /** \brief From a LAS, a text or a mesh, which have no pose. */
  bool is_survey = false;
  /** \brief Where there are several, in the order of their points; else the pose above
   * is that of the one. */
  std::vector<Scan> scans = {};

  std::size_t
  size () const
  {
    return sizeOf (points);
  }
};

/** \brief Whether a file is called like one of these, or .laz. */
bool
hasCloudExtension (const std::string& file);

/** \brief Whether a file in a folder is taken for a cloud: not .txt, .csv, .npy and
 * meshes, which mostly are something else there, nor .laz without LASzip. */
bool
isCloudFile (const std::string& file);

/** \brief Those of \ref isCloudFile, for messages: ".pcd, .ply, ... or .bin". */
std::string
folderExtensions ();

/** \brief Reads a cloud, .laz where LASzip is. All formats are listed in
 * cloud_file.cpp; programs and Python have those. The readers are our own: PCL's crash
 * on broken headers, and are in a library that loads VTK and more.
 * \throws UsageError for another extension, WorkError if the file is missing, a folder,
 * gzip, malformed, truncated or without points, or has no x, y and z */
FileCloud
loadCloud (const std::string& file);

/** \brief A cloud of so many points, whose bytes are to come, as another is. */
FileCloud
emptyLike (const FileCloud& cloud, std::size_t size);

/** \brief Sets fields of the points of a cloud from \p first on that \p part has: none
 * for the header of a file. */
using SetFields = std::function<void (FileCloud& part, std::size_t first)>;

/** \brief Writes a .ply (\ref plyHeader) or else a binary PCD by \ref writeFile.
 * \param[in] set_fields changes what is written, part after part: large clouds need no
 * room for another */
void
saveCloud (const std::string& file,
           const FileCloud& cloud,
           const SetFields& set_fields = {});

/** \brief What stands for the standard streams where a file name is expected. */
inline constexpr const char* standard_stream = "-";

/** \brief How the standard input is called in messages. */
inline constexpr const char* standard_input = "standard input";

/** \brief Reads the cloud that is piped into the program, by way of a temporary file
 * ($TMPDIR); text is what begins as no other format does; a KITTI .bin and an .obj do
 * not tell.
 * \throws UsageError if nothing is piped in, WorkError as \ref loadCloud, Interrupted */
FileCloud
loadStandardInput ();

/** \brief Declares a field behind the others, of a type of pcl::PCLPointField. */
void
addField (const std::string& name,
          std::uint8_t datatype,
          pcl::PCLPointCloud2& points,
          pcl::uindex_t count = 1);

bool
hasField (const FileCloud& cloud, const std::string& name);

/** \brief Sets a field of four bytes of every point, of as many \p values: in place of
 * the one of its name, which reaches to the next one, else before the one called
 * \p before, else at the end. */
void
setField (FileCloud& cloud,
          const std::string& name,
          std::uint8_t datatype,
          const void* values,
          const std::string& before = "");

} // namespace pcl_ops::apps
