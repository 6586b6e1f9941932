// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz_targets.h"
#include <cli/errors.h>
#include <io/cloud_file.h>
#include <io/las_file.h>
#include <io/shifted_cloud.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <new>
#include <numeric>
#include <vector>

namespace pcl_ops::fuzz {

namespace {

/** A file for one input after the other; in memory where there is a folder for that. */
class TemporaryFile {
public:
  explicit TemporaryFile (const std::string& extension)
  {
    namespace fs = std::filesystem;
    const fs::path in_memory = "/dev/shm";
    const fs::path folder =
        ::access (in_memory.c_str(), W_OK) == 0 ? in_memory : fs::temp_directory_path();
    path_ = folder / ("pcl_ops_fuzz_" + std::to_string (::getpid()) + extension);
  }
  TemporaryFile (const TemporaryFile&) = delete;
  TemporaryFile&
  operator= (const TemporaryFile&) = delete;
  ~TemporaryFile()
  {
    std::error_code ignored;
    std::filesystem::remove (path_, ignored);
  }

  std::string
  write (const Bytes& bytes) const
  {
    std::ofstream (path_, std::ios::binary)
        .write (reinterpret_cast<const char*> (bytes.data()),
                static_cast<std::streamsize> (bytes.size()));
    return path_.string();
  }

private:
  std::filesystem::path path_;
};

/** Does nothing with the cloud. */
void
leave (const apps::FileCloud&)
{}

template <typename Use>
void
load (const Bytes& bytes, const TemporaryFile& file, Use&& use)
{
  try {
    const apps::FileCloud cloud = apps::loadCloud (file.write (bytes));
    promise (cloud.size() > 0, "a cloud that was loaded has points");
    promise (cloud.points.data.size() == cloud.size() * cloud.points.point_step,
             "a cloud has as many bytes as its size says");
    promise (apps::shiftedCloudOf (cloud).cloud->size() == cloud.size(),
             "every point has coordinates");
    use (cloud);
  }
  catch (const apps::ProgramError& error) {
    promise (std::string (error.what()).find ('\n') == std::string::npos,
             "an error is one line");
  }
  catch (const std::bad_alloc&) {
    // A program says so in one line.
  }
}

} // namespace

void
loadPcd (const Bytes& bytes)
{
  static const TemporaryFile file (".pcd");
  load (bytes, file, leave);
}

void
loadPly (const Bytes& bytes)
{
  static const TemporaryFile file (".ply");
  load (bytes, file, leave);
}

void
loadText (const Bytes& bytes)
{
  static const TemporaryFile file (".xyz"), copy ("_copy.pcd");
  load (bytes, file, [] (const apps::FileCloud& cloud) {
    for (const pcl::PCLPointField& field : cloud.points.fields)
      promise (field.datatype == pcl::PCLPointField::FLOAT64,
               "a column keeps the digits it has");
    const std::string name = copy.write ({});
    apps::saveCloud (name, cloud);
    promise (apps::loadCloud (name).points.data == cloud.points.data,
             "the names of columns are those of fields");
  });
}

void
loadLas (const Bytes& bytes)
{
  static const TemporaryFile file (".las"), labelled_file ("_labelled.las");
  load (bytes, file, [] (const apps::FileCloud& cloud) {
    if (!cloud.las->problemOfLabels().empty())
      return;
    std::vector<std::uint32_t> labels (cloud.size());
    std::iota (labels.begin(), labels.end(), 1U);
    const std::string name = labelled_file.write ({});
    apps::saveLabelledLas (name, *cloud.las, labels);
    apps::FileCloud labelled = apps::loadCloud (name), expected = cloud;
    apps::setLabels (expected, labels);
    promise (labelled.points.data == expected.points.data,
             "labels and points are read as they were written");
  });
}

} // namespace pcl_ops::fuzz
