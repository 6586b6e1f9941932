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

#include <deque>
#include <iostream>
#include <new>
#include <numeric>
#include <sstream>

namespace pcl_ops::fuzz {

namespace {

template <typename Use>
void
load (const Bytes& bytes, const std::string& extension, Use&& use)
{
  const apps::Spool file (extension, "fuzz");
  file.fill ([&bytes] (std::ostream& stream) {
    stream.write (reinterpret_cast<const char*> (bytes.data()), bytes.size());
  });
  try {
    const apps::FileCloud cloud = apps::loadCloud (file.name());
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
  load (bytes, ".xyz", [] (const apps::FileCloud& cloud) {
    for (const pcl::PCLPointField& field : cloud.points.fields)
      promise (field.datatype == pcl::PCLPointField::FLOAT64,
               "a column keeps the digits it has");
    const apps::Spool copy (".pcd", "fuzz");
    apps::saveCloud (copy.name(), cloud);
    promise (apps::loadCloud (copy.name()).points.data == cloud.points.data,
             "the names of columns are those of fields");
  });
}

void
loadLas (const Bytes& bytes)
{
  load (bytes, ".las", [] (const apps::FileCloud& cloud) {
    if (!cloud.las->validate ({apps::label_field}).empty())
      return;
    std::vector<std::uint32_t> labels (cloud.size());
    std::iota (labels.begin(), labels.end(), 1U);
    const apps::Spool file (".las", "fuzz");
    apps::saveLabelledLas (file.name(), *cloud.las, labels);
    apps::FileCloud labelled = apps::loadCloud (file.name()), expected = cloud;
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
  if (!line.parse (argv.size(), argv.data()))
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
  promise (apps::labelsOf (found.planes, corner->size()).size() == corner->size(),
           "every point has a label");
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
    promise (*error.what() != '\0', "an error says what is wrong");
  }
}

} // namespace

const Targets&
allTargets ()
{
  static const Targets targets = [] {
    Targets all = {
        {"pcd", [] (const Bytes& bytes) { load (bytes, ".pcd", [] (auto&) {}); }},
        {"ply", [] (const Bytes& bytes) { load (bytes, ".ply", [] (auto&) {}); }},
        {"las", loadLas},
        {"ascii", loadText},
        {"options", readOptions}};
    all.merge (detectorTargets());
    return all;
  }();
  return targets;
}

} // namespace pcl_ops::fuzz
