// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "parts.h"

#include <pcl/common/point_tests.h>

#include <cli/errors.h>
#include <io/output_file.h>
#include <pcl_ops/orientation.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <iomanip>
#include <sstream>
#include <system_error>

namespace fs = std::filesystem;

namespace pcl_ops::apps {

namespace {

/** \brief Some points of a cloud. PCL's copyPointCloud counts bytes in 32 bits. */
FileCloud
pointsOf (const FileCloud& cloud, const pcl::Indices& indices)
{
  const std::size_t step = cloud.points.point_step;
  FileCloud part{{}, cloud.origin, cloud.orientation};
  part.points.header = cloud.points.header;
  part.points.fields = cloud.points.fields;
  part.points.is_bigendian = cloud.points.is_bigendian;
  part.points.is_dense = cloud.points.is_dense;
  part.points.point_step = cloud.points.point_step;
  part.points.width = static_cast<pcl::uindex_t> (indices.size());
  part.points.height = 1;
  part.points.row_step = part.points.width * part.points.point_step;
  part.points.data.reserve (indices.size() * step);
  for (const pcl::index_t index : indices) {
    const std::uint8_t* const point =
        cloud.points.data.data() + static_cast<std::size_t> (index) * step;
    part.points.data.insert (part.points.data.end(), point, point + step);
  }
  return part;
}

constexpr const char* start_of_name = "plane_";
constexpr std::size_t fewest_digits = 3;

std::string
planeFile (std::size_t id, const PlaneSegment& plane, const std::string& extension)
{
  std::ostringstream name;
  name << start_of_name << std::setfill ('0') << std::setw (int (fewest_digits)) << id
       << "_" << toString (plane.orientation) << extension;
  return name.str();
}

std::vector<fs::path>
planeFilesIn (const fs::path& folder)
{
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator (folder))
    if (entry.is_regular_file() && isPlaneFile (entry.path().filename().string()))
      files.push_back (entry.path());
  return files;
}

fs::path
temporaryFolderIn (const std::string& folder)
{
  std::string name = (fs::path (folder) / ".pcl_ops.XXXXXX").string();
  if (::mkdtemp (name.data()) == nullptr)
    throw fs::filesystem_error (folder,
                                std::error_code (errno, std::generic_category()));
  return name;
}

void
exchangePlanes (const fs::path& folder, const fs::path& with)
{
  // Other runs that exchange the planes of the folder wait for this one.
  const FolderLock lock (folder);
  lock.wait();
  std::vector<fs::path> stale = planeFilesIn (folder);
  const std::vector<fs::path> written = planeFilesIn (with);
  for (const fs::path& file : written)
    if (const fs::path target = folder / file.filename(); fs::is_directory (target))
      throw fs::filesystem_error (target.string(),
                                  std::make_error_code (std::errc::is_a_directory));
  for (const fs::path& file : written) {
    const fs::path target = folder / file.filename();
    fs::rename (file, target);
    stale.erase (std::remove (stale.begin(), stale.end(), target), stale.end());
  }
  for (const fs::path& file : stale)
    fs::remove (file);
}

} // namespace

bool
isPlaneFile (const std::string& name)
{
  const std::string start = start_of_name;
  if (name.compare (0, start.size(), start) != 0)
    return false;
  const std::size_t end = name.find_first_not_of ("0123456789", start.size());
  if (end == std::string::npos || end - start.size() < fewest_digits)
    return false;
  const std::string extension = extensionOf (name);
  if (extension != ".pcd" && extension != ".ply")
    return false;
  for (const char* orientation : {"_horizontal", "_vertical", "_other"})
    if (name.compare (end, std::string::npos, orientation + extension) == 0)
      return true;
  return false;
}

void
saveRest (const std::string& file,
          const FileCloud& cloud,
          const ShiftedCloud& shifted,
          const std::vector<std::uint32_t>& labels)
{
  pcl::Indices rest;
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (labels[i] == 0 && pcl::isFinite ((*shifted.cloud)[i]))
      rest.push_back (static_cast<pcl::index_t> (i));
  saveCloud (file, pointsOf (cloud, rest));
}

void
savePlaneClouds (const std::string& folder,
                 const FileCloud& cloud,
                 const std::vector<PlaneSegment>& planes,
                 const std::vector<std::uint32_t>& ids,
                 const std::string& extension)
{
  makeFolder (folder);
  try {
    const TemporaryPath written (temporaryFolderIn (folder));
    for (std::size_t i = 0; i < planes.size(); ++i)
      saveCloud ((written.path() / planeFile (ids[i], planes[i], extension)).string(),
                 pointsOf (cloud, planes[i].inliers));
    exchangePlanes (folder, written.path());
  }
  catch (const fs::filesystem_error& error) {
    throw OutputError (folder,
                       "cannot be written to (" + error.code().message() +
                           "); choose another folder");
  }
  catch (const OutputError& error) {
    throw OutputError (folder, error.problem); // the file's name is a temporary one
  }
}

} // namespace pcl_ops::apps
