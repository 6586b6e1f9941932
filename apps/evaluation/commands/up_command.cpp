// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "up_command.h"

#include <cli/command_line.h>
#include <cli/memory.h>
#include <cli/program.h>
#include <evaluation/data/data_sets.h>
#include <evaluation/experiments/up_accuracy.h>

#include <iostream>

namespace pcl_ops::evaluation {

namespace {

struct UpOptions {
  std::vector<std::string> data_sets;
  Eigen::Vector3f up = Eigen::Vector3f::UnitZ();
  unsigned rotations = 5;
  std::uint32_t seed = 42;
  double least_confidence = UpAxisParameters().least_confidence;
};

bool
readOptions (int argc, const char* const* argv, UpOptions& options)
{
  constexpr double most_rotations = 10'000;
  apps::CommandLine line (
      "pcl_ops_evaluate up",
      "Tells how well the up axis is found: turns each cloud at random, finds its\n"
      "planes by the default preset and which way is up from them, and compares with\n"
      "the data set's own. An answer more than 10 degrees off is wrong.",
      PCL_OPS_VERSION);
  line.addArguments ("DATASET", options.data_sets, 1, data_set_help);
  line.addDirection ("up", options.up, "direction against gravity of clouds: (0,0,1)");
  line.addNumber ("rotations",
                  "R",
                  apps::Range::from (1).upTo (most_rotations),
                  options.rotations,
                  "times each cloud is turned (5)");
  line.addNumber (
      "seed", "S", apps::Range::from (0), options.seed, "of the rotations (42)");
  line.addNumber ("least-confidence",
                  "P",
                  apps::Range::from (0).upTo (1),
                  options.least_confidence,
                  "below it there is no answer (0.7)");
  return line.parse (argc, argv);
}

UpGuesses
guessesOn (const DataSet& data_set, const UpOptions& options)
{
  UpGuesses result{data_set.name, 0, {}};
  apps::Random random (options.seed);
  for (const CloudSource& source : data_set.clouds) {
    apps::inMemory (source.name, "give a smaller cloud", [&] {
      const EvaluationCloud cloud = source.load();
      for (unsigned i = 0; i < options.rotations; ++i) {
        ++result.tries;
        if (const auto guess = guessUp (cloud, random))
          result.guesses.push_back (*guess);
      }
    });
    std::cerr << data_set.name << ' ' << source.name << std::endl;
  }
  return result;
}

} // namespace

int
upCommand (int argc, const char* const* argv)
{
  UpOptions options;
  if (!readOptions (argc, argv, options))
    return apps::ExitCode::done;
  std::vector<DataSet> data_sets;
  for (const std::string& text : options.data_sets)
    data_sets.push_back (dataSetOf (text, options.up.cast<double>().normalized()));
  std::vector<UpGuesses> all;
  for (const DataSet& data_set : data_sets)
    all.push_back (guessesOn (data_set, options));
  std::cout << errorTable (all, options.least_confidence) << reliabilityTable (all);
  return apps::ExitCode::done;
}

} // namespace pcl_ops::evaluation
