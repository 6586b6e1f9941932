// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gnuplot.h"

#include <boost/process/child.hpp>
#include <boost/process/io.hpp>
#include <boost/process/search_path.hpp>
#include <boost/process/start_dir.hpp>

#include <io/output_file.h>

#include <filesystem>

namespace pcl_ops::evaluation {

namespace {

namespace fs = std::filesystem;

/** False where there is no gnuplot. */
bool
runGnuplot (const fs::path& script)
{
  namespace process = boost::process;
  const auto gnuplot = process::search_path ("gnuplot");
  if (gnuplot.empty())
    return false;
  std::error_code error;
  process::child child (gnuplot,
                        script.filename().string(),
                        process::start_dir = script.parent_path().string(),
                        process::std_out > process::null,
                        process::std_err > process::null,
                        error);
  child.wait (error);
  return !error && child.exit_code() == 0;
}

} // namespace

bool
writePlot (const Plot& plot, const std::string& folder)
{
  const fs::path script = fs::path (folder) / (plot.name + ".gp");
  apps::writeTextFile ((fs::path (folder) / (plot.name + ".dat")).string(), plot.data);
  apps::writeTextFile (
      script.string(),
      "set terminal pngcairo size 1200,1000\nset output '" + plot.name +
          ".png'\nset grid\nset key outside right noenhanced\n" + plot.commands);
  return runGnuplot (script);
}

} // namespace pcl_ops::evaluation
