// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "commands.h"
#include <cli/command_line.h>
#include <cli/errors.h>
#include <cli/program.h>
#include <evaluation/report/evaluation_run.h>
#include <io/output_file.h>
#include <unistd.h>

#include <filesystem>
#include <iostream>

namespace pcl_ops::evaluation {

namespace {

namespace fs = std::filesystem;

/** More clouds at a time than any machine this runs on has cores. */
constexpr double max_jobs = 256;
constexpr double max_neighbors = 10'000, max_seconds = 1e6;

struct RunOptions {
  std::string folder;
  std::vector<std::string> data_sets;
  Eigen::Vector3f up = Eigen::Vector3f::UnitZ();
  std::string detectors = "all";
  EvaluationPlan plan;
};

bool
readOptions (int argc, const char* const* argv, RunOptions& options)
{
  apps::CommandLine line (
      "pcl_ops_evaluate run",
      "Runs detectors over data sets and writes results.csv, of which report.py makes\n"
      "tables and plots. Run it again to go on after a stop: rows that are there are\n"
      "not computed again.",
      PCL_OPS_VERSION);
  line.addArgument ("OUTPUT", options.folder, "folder of the results");
  line.addArguments ("DATASET", options.data_sets, data_set_help);
  line.addUpAxis (options.up, "against gravity in clouds; camera: 0,-1,0 (0,0,1)");
  TruthParameters& truth = options.plan.truth;
  line.addNumber ("truth-neighbors",
                  "K",
                  apps::Range::from (3).upTo (max_neighbors),
                  truth.growing.neighbors,
                  "neighborhood of grown truth (100)");
  line.addNumber ("min-plane-points",
                  "N",
                  apps::Range::from (0),
                  truth.min_points,
                  "true planes with fewer points are none (50)");
  line.addText ("detectors",
                "LIST",
                options.detectors,
                "names and groups, see pcl_ops_evaluate detectors (all)");
  line.addNumber ("jobs",
                  "N",
                  apps::Range::from (1).upTo (max_jobs),
                  options.plan.jobs,
                  "clouds at a time; only 1 leaves times undisturbed (1)");
  line.addText ("labels",
                "FOLDER",
                options.plan.labels_folder,
                "save each new result, and the truth, as a labeled cloud");
  RunSettings& settings = options.plan.settings;
  line.addNumber ("threshold",
                  "M",
                  apps::Range::above (0),
                  settings.peer_threshold,
                  "distance to a plane that detectors of others are given (0.05)");
  line.addNumber (
      "peers-noise",
      "M",
      apps::Range::above (0),
      settings.peer_noise,
      "noise that those of the group peers-measured are tuned to (measured)");
  line.addNumber ("time-limit",
                  "S",
                  apps::Range::from (0).upTo (max_seconds),
                  options.plan.time_limit,
                  "for a detector of others on a cloud, 0 for none (600)");
  line.addNumber ("seed",
                  "S",
                  apps::Range::from (0),
                  options.plan.settings.seed,
                  "of detectors (42)");
  return line.parse (argc, argv);
}

/** Checks everything there is to check before the work begins. */
EvaluationPlan
planOf (const RunOptions& options)
{
  EvaluationPlan plan = options.plan;
  plan.configurations = selectConfigurations (options.detectors);
  plan.data_sets = dataSetsOf (options.data_sets, options.up);
  apps::makeFolder (options.folder);
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
  std::cout << summary.clouds << " clouds evaluated, " << summary.new_rows
            << " new rows; " << summary.broken_clouds << " clouds left out, "
            << summary.failed_runs << " runs failed, " << summary.stopped_runs
            << " stopped\n";
  const bool is_complete = summary.broken_clouds == 0 && summary.failed_runs == 0;
  return is_complete ? apps::ExitCode::done : apps::ExitCode::work_failed;
}

int
detectorsCommand (int argc, const char* const* argv)
{
  apps::CommandLine line (
      "pcl_ops_evaluate detectors",
      "Lists the configurations a run can have, their groups and versions.",
      PCL_OPS_VERSION);
  if (!line.parse (argc, argv))
    return apps::ExitCode::done;
  for (const Configuration& configuration : allConfigurations()) {
    std::cout << configuration.name;
    for (const std::string& group : configuration.groups)
      std::cout << ' ' << group;
    const std::string& version = configuration.version;
    std::cout << ", " << (version.empty() ? "pcl_ops " PCL_OPS_VERSION : version)
              << '\n';
  }
  return apps::ExitCode::done;
}

} // namespace pcl_ops::evaluation
