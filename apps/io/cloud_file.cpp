// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_file.h"

#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>

#include "cloud_fields.h"
#include "input_file.h"
#include "las_file.h"
#include "laz_file.h"
#include "output_file.h"
#include "pcd_header.h"
#include "ply_header.h"
#include "ply_writer.h"
#include "spool.h"
#include "text_file.h"
#include <cli/errors.h>

#include <cerrno>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <new>
#include <system_error>

namespace fs = std::filesystem;

namespace pcl_ops::apps {

namespace {

[[noreturn]] void
failGzip (const std::string& file)
{
  throw WorkError (file, "is compressed (gzip); decompress it, e.g. by gunzip");
}

/** \brief Finds it by its first bytes, whatever the extension. */
void
refuseGzip (const std::string& file)
{
  std::ifstream stream (file, std::ios::binary);
  if (stream.get() == 0x1f && stream.get() == 0x8b)
    failGzip (file);
}

/** \brief PCL's reader; what it throws or returns on failure becomes one error. */
void
readWith (pcl::FileReader&& reader, const std::string& file, FileCloud& cloud)
{
  std::string reason;
  try {
    int version = 0;
    errno = 0;
    if (reader.read (file, cloud.points, cloud.origin, cloud.orientation, version) >= 0)
      return;
    if (errno == ENOMEM) // it could not map the file
      throw std::bad_alloc();
    reason = "its data does not match its header";
  }
  catch (const std::bad_alloc&) {
    throw;
  }
  catch (const std::exception& error) {
    reason = error.what();
  }
  throw WorkError (file, "cannot be read: " + reason + "; is it truncated or damaged?");
}

/** \brief A PLY's camera may claim a size of the image that is not that of the cloud.
 */
void
makeSizeValid (const std::string& file, pcl::PCLPointCloud2& points)
{
  const std::size_t size =
      points.point_step == 0 ? 0 : points.data.size() / points.point_step;
  if (size * points.point_step != points.data.size())
    throw WorkError (file, "is damaged: it ends within a point; write it again");
  if (size == 0)
    throw WorkError (file, "has no points; give a cloud that has");
  if (static_cast<std::size_t> (points.width) * points.height == size)
    return;
  points.width = static_cast<pcl::uindex_t> (size);
  points.height = 1;
}

void
makePoseValid (FileCloud& cloud)
{
  if (!cloud.origin.head<3>().allFinite())
    cloud.origin.setZero();
  const float norm = cloud.orientation.norm();
  if (std::isfinite (norm) && norm > 0.0f)
    cloud.orientation.normalize();
  else
    cloud.orientation.setIdentity();
}

} // namespace

bool
isCloudFile (const std::string& file)
{
  const std::string extension = extensionOf (file);
  return extension == ".pcd" || extension == ".ply" || extension == ".las" ||
         (extension == ".laz" && hasLaszip()) || extension == ".xyz" ||
         extension == ".pts";
}

bool
hasCloudExtension (const std::string& file)
{
  return isCloudFile (file) || isTextFile (file) || isLasName (file);
}

FileCloud
loadCloud (const std::string& file)
{
  const std::string extension = extensionOf (file);
  if (extension == ".gz")
    failGzip (file);
  if (!hasCloudExtension (file))
    throw UsageError (file,
                      std::string ("has an unknown extension; give a ") +
                          cloud_extensions + " file");
  checkReadable (file, std::string ("a ") + cloud_extensions + " file");
  refuseGzip (file);
  FileCloud cloud;
  if (extension == ".pcd") {
    const Viewpoint viewpoint = checkPcdFile (file);
    readWith (pcl::PCDReader(), file, cloud);
    cloud.origin << viewpoint.origin, 0.0f;
    cloud.orientation = viewpoint.orientation;
  }
  else if (isLasName (file)) {
    cloud.las = openLas (file);
    cloud.points = cloud.las->readPoints();
  }
  else if (isTextFile (file))
    cloud.points = readTextCloud (file);
  else {
    checkPlyFile (file);
    readWith (pcl::PLYReader(), file, cloud);
  }
  makeSizeValid (file, cloud.points);
  for (const char* axis : {"x", "y", "z"})
    if (!hasField (cloud, axis))
      throw WorkError (file,
                       std::string ("has no field ") + axis +
                           "; give a cloud with x, y and z");
  makePoseValid (cloud);
  return cloud;
}

std::shared_ptr<LasFile>
openLas (const std::string& file)
{
  checkReadable (file, std::string ("a ") + cloud_extensions + " file");
  if (!isCompressedLas (file))
    return std::make_shared<LasFile> (file);
  const Spool las (".las", file);
  las.fill ([&] (std::ostream& stream) { decompressLaz (file, stream); });
  try {
    return std::make_shared<LasFile> (las.name());
  }
  catch (const WorkError& error) {
    throw WorkError (file, error.problem);
  }
}

void
savePcd (const std::string& file, const FileCloud& cloud)
{
  // PCL's own writeBinary fills the file up to a page, which other readers stumble
  // over.
  const std::string header = pcl::PCDWriter().generateHeaderBinary (
      cloud.points, cloud.origin, cloud.orientation);
  writeFile (file, [&] (std::ostream& stream) {
    stream << header << "DATA binary\n";
    stream.write (reinterpret_cast<const char*> (cloud.points.data.data()),
                  static_cast<std::streamsize> (cloud.points.data.size()));
  });
}

void
saveCloud (const std::string& file, const FileCloud& cloud)
{
  if (extensionOf (file) == ".ply")
    savePly (file, cloud);
  else
    savePcd (file, cloud);
}

} // namespace pcl_ops::apps
