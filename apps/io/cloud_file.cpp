// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_file.h"

#include "cloud_fields.h"
#include "input_file.h"
#include "las_file.h"
#include "laz_file.h"
#include "output_file.h"
#include "pcd_file.h"
#include "ply_reader.h"
#include "ply_writer.h"
#include "spool.h"
#include "text_file.h"
#include <cli/errors.h>

#include <cmath>
#include <fstream>

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
  if (extension == ".pcd")
    cloud = readPcd (file);
  else if (extension == ".ply")
    cloud = readPly (file);
  else if (isTextFile (file))
    cloud.points = readTextCloud (file);
  else {
    cloud.las = openLas (file);
    cloud.points = cloud.las->readPoints();
  }
  for (const char* axis : {"x", "y", "z"})
    if (!hasField (cloud, axis))
      throw WorkError (file,
                       std::string ("has no field ") + axis +
                           "; give a cloud with x, y and z");
  makePoseValid (cloud);
  cloud.is_survey = extension != ".pcd" && extension != ".ply";
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
  writeFile (file, [&] (std::ostream& stream) {
    stream << pcdHeader (cloud);
    stream.write (reinterpret_cast<const char*> (cloud.points.data.data()),
                  static_cast<std::streamsize> (cloud.points.data.size()));
  });
}

void
saveCloud (const std::string& file, const FileCloud& cloud)
{
  if (extensionOf (file) == ".ply")
    writeFile (file, [&] (auto& stream) { writePly (cloud.points, stream); });
  else
    savePcd (file, cloud);
}

} // namespace pcl_ops::apps
