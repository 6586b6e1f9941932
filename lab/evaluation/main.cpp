// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cli/command_line.h>
#include <cli/errors.h>
#include <cli/program.h>
#include <evaluate/commands.h>
#include <evaluation/detectors/own_labels.h>
#include <evaluation/edges_command.h>
#include <evaluation/report/evaluation_run.h>
#include <io/output_file.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <optional>
#include <set>

namespace {

using namespace pcl_ops;
using namespace pcl_ops::apps;
using namespace pcl_ops::evaluation;

Eigen::Vector3f
parseShift (const std::string& text)
{
  constexpr double largest = 1e6; // above, floats have steps of 6 cm and more [m]
  return Eigen::Vector3f (
      parseNumbers<float, 3> ("--shift",
                              text,
                              from (-largest).upTo (largest),
                              "'" + text +
                                  "' is not x,y,z; give three lengths, as 0.3,0.1,0.2")
          .data());
}

/** Options of a run from which \ref readOptions completes the plan. */
struct RunOptions {
  std::string folder;                            // of the results
  std::vector<std::string> data_sets;            // texts for dataSetOf
  Eigen::Vector3f up = Eigen::Vector3f::UnitZ(); // against gravity
  std::string detectors;                  // list for selectConfigurations; may be empty
  std::vector<std::string> own_labels;    // texts NAME=FOLDER for ownLabels
  std::optional<std::size_t> most_clouds; // of each data set; nullopt: all
};

/** Declares options that select and change clouds of the data sets. */
void
declareCloudOptions (CommandLine& line, RunOptions& options, EvaluationPlan& plan)
{
  line.add ("shift X,Y,Z",
            [&plan] (const std::string& text) { plan.shift = parseShift (text); })
      .help ("added to all points: voxels begin elsewhere in them (0,0,0)");
  line.add ("changes", plan.runs_on_changes)
      .help ("run on changed copies of the clouds, too, and write how far they agree");
  line.add ("most-clouds N", options.most_clouds, from (1))
      .help ("of each DATASET, evenly spread (all)");
  line.add ("most-points N", plan.most_points, from (1))
      .help ("of each cloud, drawn at random and without an image (all)");
}

void
declareOptions (CommandLine& line, RunOptions& options, EvaluationPlan& plan)
{
  line.addArgument ("OUTPUT", options.folder, "folder of the results");
  line.addArguments ("DATASET", options.data_sets, data_set_help);
  line.addUpAxis (options.up)
      .help ("against gravity in clouds; camera: 0,-1,0 (0,0,1)");
  line.add ("truth-neighbors K", plan.truth.neighbors, from (3).upTo (10'000))
      .help ("neighborhood of grown truth (100)");
  line.add ("min-plane-points N", plan.truth.min_points, from (0))
      .help ("true planes with fewer points are none (50)");
  line.add ("detectors LIST", options.detectors)
      .help ("names and groups, see pcl_ops_evaluate detectors, or none (all; none "
             "with --results)");
  line.add ("results NAME=FOLDER",
            [&options] (auto& text) { options.own_labels.push_back (text); })
      .help ("labels of a detector of yours: DATA_SET/CLOUD, as in the folder of "
             "--labels, or CLOUD .npy, .txt or .pcd; may be given several times")
      .repeated();
  line.add ("jobs N", plan.jobs, from (1).upTo (256))
      .help ("clouds at a time; only 1 leaves times undisturbed (1)");
  line.add ("labels FOLDER", plan.labels_folder)
      .help ("save each new result, and the truth, as a labeled cloud; with "
             "--detectors none the truth only");
  line.add ("threshold M", plan.settings.peer_threshold, above (0))
      .help ("distance to a plane that detectors of others are given (0.05)");
  line.add ("peers-noise M", plan.settings.peer_noise, above (0))
      .help ("noise that those of the group peers-measured are tuned to (measured)");
  line.add ("peers-neighbors K", plan.settings.peer_neighbors, from (3).upTo (10'000))
      .help ("that they estimate a normal from (24 or 30; 30 to 200 if measured)");
  line.add ("peers-min-points N", plan.settings.peer_min_points, from (1))
      .help ("points of the smallest plane they are to find (50; 500 of loops)");
  line.add ("time-limit S", plan.time_limit, from (0).upTo (1e6))
      .help ("for a detector of others on a cloud, 0 for none (600)");
  declareCloudOptions (line, options, plan);
  line.add ("seed S", plan.settings.seed, from (0)).help ("of detectors (42)");
}

/** Adds clouds of a data set to \p clouds, spread evenly over it.
 * \param[in] max_count nullopt: adds all clouds */
void
addClouds (const DataSet& all,
           std::optional<std::size_t> max_count,
           std::vector<CloudSource>& clouds)
{
  const std::size_t count = std::min (max_count.value_or (all.size()), all.size());
  for (std::size_t i = 0; i < count; ++i)
    clouds.push_back (all[i * all.size() / count]);
}

/** Returns the configurations of --detectors, and one for each --results. */
std::vector<Configuration>
configurationsOf (const RunOptions& options)
{
  const std::string by_default = options.own_labels.empty() ? "all" : "none";
  std::vector<Configuration> configurations =
      selectConfigurations (options.detectors.empty() ? by_default : options.detectors);
  std::set<std::string> names;
  for (const std::string& name_and_folder : options.own_labels) {
    configurations.push_back (ownLabels (name_and_folder));
    const std::string& name = configurations.back().name;
    if (!names.insert (name).second)
      throw UsageError ("--results",
                        "'" + name + "' is given twice; give each another name");
  }
  return configurations;
}

/** \return false if the answer was --help or --version */
bool
readOptions (int argc, const char* const* argv, EvaluationPlan& plan)
{
  CommandLine line (
      "pcl_ops_evaluate run",
      "Runs detectors over data sets and writes results.csv, of which report.py makes\n"
      "tables and plots. Run it again to go on after a stop: rows that are there are\n"
      "not computed again, but for --results.",
      PCL_OPS_VERSION);
  RunOptions options;
  declareOptions (line, options, plan);
  if (!line.parse (argc, argv))
    return false;
  plan.configurations = configurationsOf (options);
  if (plan.configurations.empty() && plan.labels_folder.empty())
    throw UsageError ("--detectors",
                      "none leaves nothing to do; give --labels or --results, too");
  for (const std::string& data_set : options.data_sets)
    addClouds (dataSetOf (data_set, options.up), options.most_clouds, plan.clouds);
  makeFolder (options.folder);
  plan.file = (std::filesystem::path (options.folder) / "results.csv").string();
  return true;
}

int
runDetectorsCommand (int argc, const char* const* argv)
{
  EvaluationPlan plan;
  if (!readOptions (argc, argv, plan))
    return ExitCode::done;
  if (std::filesystem::is_directory (plan.file))
    throw WorkError (plan.file, "is a folder; remove it or give another OUTPUT");
  const EvaluationSummary summary =
      evaluate (plan, std::cerr, isatty (STDERR_FILENO) == 1);
  std::cout << summary.clouds << " clouds evaluated, " << summary.new_rows
            << " new rows; " << summary.broken_clouds << " clouds left out, "
            << summary.failed_runs << " runs failed, " << summary.stopped_runs
            << " stopped\n";
  const bool is_complete = summary.broken_clouds == 0 && summary.failed_runs == 0;
  return is_complete ? ExitCode::done : ExitCode::work_failed;
}

int
detectorsCommand (int argc, const char* const* argv)
{
  CommandLine line (
      "pcl_ops_evaluate detectors",
      "Lists the configurations a run can have, their groups and versions.",
      PCL_OPS_VERSION);
  if (!line.parse (argc, argv))
    return ExitCode::done;
  for (const Configuration& configuration : allConfigurations()) {
    std::cout << configuration.name;
    for (const std::string& group : configuration.groups)
      std::cout << ' ' << group;
    const std::string& version = configuration.version;
    std::cout << ", " << (version.empty() ? "pcl_ops " PCL_OPS_VERSION : version)
              << '\n';
  }
  return ExitCode::done;
}

std::vector<Command>
allCommands ()
{
  std::vector<Command> commands = commandsForResults();
  commands.push_back (
      {"run", "OUTPUT DATASET...", "detectors over data sets", runDetectorsCommand});
  commands.push_back (
      {"edges", "DATASET...", "how well it is found where planes meet", edgesCommand});
  commands.push_back (
      {"detectors", "", "the detectors a run can have", detectorsCommand});
  return commands;
}

} // namespace

int
main (int argc, char** argv)
{
  return runProgram ("pcl_ops_evaluate",
                     [&] { return runCommand (allCommands(), argc, argv); });
}
