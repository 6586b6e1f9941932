// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "parts.h"

#include <pcl/common/io.h>
#include <pcl/common/point_tests.h>

#include <cli/errors.h>
#include <io/output_file.h>
#include <io/temporary_path.h>
#include <pcl_ops/orientation.h>
#include <unistd.h>

#include <filesystem>
#include <iomanip>
#include <regex>
#include <sstream>
#include <system_error>

namespace fs = std::filesystem;

namespace pcl_ops::apps {

namespace {

Cloud
pointsOf (const Cloud& cloud, const pcl::Indices& indices)
{
  Cloud part{{}, cloud.origin, cloud.orientation};
  pcl::copyPointCloud (cloud.points, indices, part.points);
  return part;
}

std::string
planeFile (std::size_t id, const PlaneSegment& plane)
{
  constexpr int kDigits = 3;
  std::ostringstream name;
  name << "plane_" << std::setfill ('0') << std::setw (kDigits) << id << "_"
       << toString (plane.orientation) << ".pcd";
  return name.str();
}

std::vector<fs::path>
planeFilesIn (const fs::path& folder)
{
  static const std::regex kName ("plane_[0-9]{3,}_(horizontal|vertical|other)\\.pcd");
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator (folder))
    if (std::regex_match (entry.path().filename().string(), kName))
      files.push_back (entry.path());
  return files;
}

} // namespace

void
saveRest (const std::string& file,
          const Cloud& cloud,
          const Positions& positions,
          const std::vector<std::uint32_t>& labels)
{
  pcl::Indices rest;
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (labels[i] == 0 && pcl::isFinite ((*positions.cloud)[i]))
      rest.push_back (static_cast<pcl::index_t> (i));
  savePcd (file, pointsOf (cloud, rest));
}

void
savePlaneClouds (const std::string& folder,
                 const Cloud& cloud,
                 const std::vector<PlaneSegment>& planes)
{
  makeFolder (folder);
  const TemporaryPath written (fs::path (folder) /
                               (".planes." + std::to_string (::getpid())));
  makeFolder (written.path().string());
  std::size_t id = 0;
  for (const PlaneSegment& plane : planes)
    savePcd ((written.path() / planeFile (++id, plane)).string(),
             pointsOf (cloud, plane.inliers));
  try {
    for (const fs::path& stale : planeFilesIn (folder))
      fs::remove (stale);
    for (const fs::path& file : planeFilesIn (written.path()))
      fs::rename (file, folder / file.filename());
  }
  catch (const fs::filesystem_error& error) {
    throw WorkError (folder,
                     "cannot be written to (" + error.code().message() +
                         "); choose another folder");
  }
}

} // namespace pcl_ops::apps
