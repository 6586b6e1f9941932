// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pictures_command.h"

#include "data_options.h"
#include <cli/errors.h>
#include <cli/memory.h>
#include <cli/program.h>
#include <evaluation/experiments/pictures.h>
#include <io/output_file.h>

#include <filesystem>
#include <iostream>
#include <sstream>

namespace pcl_ops::evaluation {

namespace {

namespace fs = std::filesystem;

struct PictureOptions {
  std::string folder;
  std::string clouds;
  std::string detectors = "table4,presets";
  std::uint32_t seed = 42;
  DataOptions data;
};

bool
readOptions (int argc, const char* const* argv, PictureOptions& options)
{
  apps::CommandLine line ("pcl_ops_evaluate pictures",
                          "Draws the truth and what detectors make of chosen clouds, "
                          "by plane and by class, "
                          "and\nwrites pictures.md, which shows them.",
                          PCL_OPS_VERSION);
  line.addArgument ("OUTPUT", options.folder, "folder of the pictures");
  addDataOptions (line, options.data);
  line.addText (
      "clouds", "TEXT", options.clouds, "only clouds with TEXT in their name (all)");
  line.addText ("detectors",
                "LIST",
                options.detectors,
                "names and groups, see pcl_ops_evaluate detectors (table4,presets)");
  line.addNumber (
      "seed", "S", apps::Range::from (0), options.seed, "of detectors (42)");
  return line.parse (argc, argv);
}

} // namespace

int
picturesCommand (int argc, const char* const* argv)
{
  PictureOptions options;
  if (!readOptions (argc, argv, options))
    return apps::ExitCode::done;
  const auto configurations = selectConfigurations (options.detectors);
  const std::vector<DataSet> data_sets = dataSetsOf (options.data);
  apps::makeFolder (options.folder);

  std::ostringstream page;
  for (const DataSet& data_set : data_sets)
    for (const CloudSource& source : data_set.clouds) {
      if (source.name.find (options.clouds) == std::string::npos)
        continue;
      page << apps::inMemory (source.name, "give a smaller cloud", [&] {
        const EvaluationCloud cloud = source.load();
        return writePictures (cloud,
                              data_set.name + " " + source.name,
                              truthOf (cloud, options.data.truth),
                              configurations,
                              options.seed,
                              options.folder);
      });
      std::cout << data_set.name << ' ' << source.name << '\n' << std::flush;
    }
  if (page.str().empty())
    throw apps::UsageError ("--clouds " + options.clouds,
                            "no cloud of the data sets has this in its name");
  apps::writeTextFile ((fs::path (options.folder) / "pictures.md").string(),
                       page.str());
  return apps::ExitCode::done;
}

} // namespace pcl_ops::evaluation
