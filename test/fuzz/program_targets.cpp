// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <boost/io/ios_state.hpp>

#include "fuzz_targets.h"
#include "scene.h"
#include <cli/command_line.h>
#include <cli/errors.h>
#include <detection/methods.h>
#include <io/cloud_file.h>
#include <io/las_file.h>
#include <io/output_file.h>
#include <io/shifted_cloud.h>
#include <unistd.h>

#include <deque>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <new>
#include <numeric>
#include <sstream>
#include <vector>

namespace pcl_ops::fuzz {

namespace {

/** A file for one input after the other; in memory where there is a folder for that. */
class TemporaryFile {
public:
  explicit TemporaryFile (const std::string& extension)
  : file_ (folder() / ("pcl_ops_fuzz_" + std::to_string (::getpid()) + extension))
  {}

  std::string
  write (const Bytes& bytes) const
  {
    std::ofstream (file_.path(), std::ios::binary)
        .write (reinterpret_cast<const char*> (bytes.data()),
                static_cast<std::streamsize> (bytes.size()));
    return file_.path().string();
  }

private:
  static std::filesystem::path
  folder ()
  {
    const char* const in_memory = "/dev/shm";
    return ::access (in_memory, W_OK) == 0 ? in_memory
                                           : std::filesystem::temp_directory_path();
  }

  apps::TemporaryPath file_;
};

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
    if (!cloud.las->validate ({apps::label_field}).empty())
      return;
    std::vector<std::uint32_t> labels (cloud.size());
    std::iota (labels.begin(), labels.end(), 1U);
    const std::string name = labelled_file.write ({});
    apps::saveLabelledLas (name, *cloud.las, labels);
    apps::FileCloud labelled = apps::loadCloud (name), expected = cloud;
    apps::setField (expected, "label", pcl::PCLPointField::UINT32, labels.data());
    promise (labelled.points.data == expected.points.data,
             "labels and points are read as they were written");
  });
}

/** In a small corner, by what stands on a line each. */
void
detectAsTold (const Bytes& bytes)
{
  std::istringstream text (std::string (bytes.begin(), bytes.end()));
  std::deque<std::string> arguments;
  std::vector<const char*> argv{"pcl_ops_segment"};
  for (std::string argument; std::getline (text, argument);)
    argv.push_back (arguments.emplace_back (argument).c_str());
  apps::CommandLine line ("pcl_ops_segment", "Finds planes", "0");
  std::string method = apps::allMethods().front().name;
  apps::DetectorOptions options;
  apps::declareMethodOptions (line, method, options);
  if (!line.parse (static_cast<int> (argv.size()), argv.data()))
    return;
  const apps::Method& chosen = apps::methodCalled (method);
  apps::checkMethodOptions (line, chosen);
  static const apps::XyzCloud::ConstPtr corner = Scene (1)
                                                     .floor (1_m, 1_m)
                                                     .wall ({0, 0}, {1, 0}, 1_m)
                                                     .spacing (5_cm)
                                                     .build()
                                                     .cloud;
  const apps::Detected found = chosen.detect (options, corner);
  const std::vector<std::uint32_t> labels =
      apps::labelsOf (found.planes, corner->size());
  promise (labels.size() == corner->size(), "every point has a label");
}

void
readOptions (const Bytes& bytes)
{
  // Takes away what --help prints.
  const std::ostringstream nothing;
  const boost::io::ios_rdbuf_saver saver (std::cout, nothing.rdbuf());
  try {
    detectAsTold (bytes);
  }
  catch (const apps::ProgramError& error) {
    promise (std::string (error.what()).size() > 0, "an error says what is wrong");
  }
}

} // namespace

const Targets&
allTargets ()
{
  static const Targets targets = [] {
    Targets all = {{"pcd",
                    [] (const Bytes& bytes) {
                      static const TemporaryFile file (".pcd");
                      load (bytes, file, [] (const auto&) {});
                    }},
                   {"ply",
                    [] (const Bytes& bytes) {
                      static const TemporaryFile file (".ply");
                      load (bytes, file, [] (const auto&) {});
                    }},
                   {"las", loadLas},
                   {"ascii", loadText},
                   {"options", readOptions}};
    all.merge (detectorTargets());
    return all;
  }();
  return targets;
}

} // namespace pcl_ops::fuzz
