// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report_command.h"

#include <cli/command_line.h>
#include <cli/errors.h>
#include <cli/program.h>
#include <evaluation/report/report.h>

#include <filesystem>
#include <iostream>

namespace pcl_ops::evaluation {

namespace fs = std::filesystem;

int
reportCommand (int argc, const char* const* argv)
{
  std::string folder;
  apps::CommandLine line ("pcl_ops_evaluate report",
                          "Makes tables and plots anew from a folder's results.csv.",
                          PCL_OPS_VERSION);
  line.addArgument ("OUTPUT", folder, "folder that pcl_ops_evaluate run wrote");
  if (!line.parse (argc, argv))
    return apps::ExitCode::done;
  const std::string file = (fs::path (folder) / "results.csv").string();
  if (!fs::exists (file))
    throw apps::WorkError (file, "is not there; give the OUTPUT of a run");
  const ResultsFile results (file);
  if (results.rows().empty())
    throw apps::WorkError (file, "has no row yet; run an evaluation first");
  writeReport (results.rows(), folder, std::cout);
  return apps::ExitCode::done;
}

} // namespace pcl_ops::evaluation
