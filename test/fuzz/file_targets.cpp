// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz_targets.h"
#include <cli/errors.h>
#include <io/cloud_fields.h>
#include <io/cloud_file.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <new>

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

void
load (const Bytes& bytes, const TemporaryFile& file)
{
  try {
    const apps::FileCloud cloud = apps::loadCloud (file.write (bytes));
    promise (cloud.size() > 0, "a cloud that was loaded has points");
    promise (cloud.points.data.size() == cloud.size() * cloud.points.point_step,
             "a cloud has as many bytes as its size says");
    promise (apps::shiftedCloudOf (cloud).cloud->size() == cloud.size(),
             "every point has coordinates");
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
  load (bytes, file);
}

void
loadPly (const Bytes& bytes)
{
  static const TemporaryFile file (".ply");
  load (bytes, file);
}

} // namespace pcl_ops::fuzz
