// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "run_command.h"

#include "data_options.h"
#include <cli/command_line.h>
#include <cli/program.h>
#include <evaluation/experiments/evaluation_run.h>
#include <evaluation/report/report.h>
#include <io/output_file.h>
#include <unistd.h>

#include <filesystem>
#include <iostream>

namespace pcl_ops::evaluation {

namespace {

namespace fs = std::filesystem;

/** More clouds at a time than any machine this runs on has cores. */
constexpr double most_jobs = 256;

struct RunOptions {
  std::string folder;
  std::string detectors = "all";
  DataOptions data;
  EvaluationPlan plan;
};

bool
readOptions (int argc, const char* const* argv, RunOptions& options)
{
  apps::CommandLine line (
      "pcl_ops_evaluate run",
      "Runs detectors over data sets and writes results.csv, tables and plots. Run it "
      "again\nto go on after a stop: rows in results.csv are not computed again.",
      PCL_OPS_VERSION);
  line.addArgument ("OUTPUT", options.folder, "folder of the results");
  addDataOptions (line, options.data);
  line.addText ("detectors",
                "LIST",
                options.detectors,
                "names and groups, see pcl_ops_evaluate detectors (all)");
  line.addNumber ("jobs",
                  "N",
                  apps::Range::from (1).upTo (most_jobs),
                  options.plan.jobs,
                  "clouds at a time; only 1 leaves times undisturbed (1)");
  line.addNumber (
      "seed", "S", apps::Range::from (0), options.plan.seed, "of detectors (42)");
  return line.parse (argc, argv);
}

/** Checks everything there is to check before the work begins. */
EvaluationPlan
planOf (const RunOptions& options)
{
  EvaluationPlan plan = options.plan;
  plan.configurations = selectConfigurations (options.detectors);
  plan.data_sets = dataSetsOf (options.data);
  plan.truth = options.data.truth;
  if (plan.truth.cache_folder.empty())
    plan.truth.cache_folder = (fs::path (options.folder) / "truth").string();
  apps::makeFolder (options.folder);
  apps::makeFolder (plan.truth.cache_folder);
  return plan;
}

} // namespace

int
runCommand (int argc, const char* const* argv)
{
  RunOptions options;
  if (!readOptions (argc, argv, options))
    return apps::ExitCode::done;
  const EvaluationPlan plan = planOf (options);
  ResultsFile results ((fs::path (options.folder) / "results.csv").string());
  const EvaluationSummary summary =
      evaluate (plan, results, std::cerr, isatty (STDERR_FILENO) == 1);
  if (!results.rows().empty())
    writeReport (results.rows(), options.folder, std::cout);
  std::cout << summary.clouds << " clouds evaluated, " << summary.new_rows
            << " new rows; " << summary.broken_clouds << " clouds left out, "
            << summary.failed_runs << " runs failed\n";
  const bool is_complete = summary.broken_clouds == 0 && summary.failed_runs == 0;
  return is_complete ? apps::ExitCode::done : apps::ExitCode::work_failed;
}

} // namespace pcl_ops::evaluation
