// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "truth_command.h"

#include "data_options.h"
#include <cli/memory.h>
#include <cli/program.h>
#include <evaluation/metrics/metrics.h>
#include <evaluation/report/text_table.h>
#include <numbers/fraction.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <sstream>

namespace pcl_ops::evaluation {

namespace {

struct TruthOptions {
  std::vector<int> neighbors{15, 30, 60, 100, 150};
  unsigned threads = 0;
  DataOptions data;
};

std::vector<int>
numbersOf (const std::string& list)
{
  std::vector<int> numbers;
  std::istringstream stream (list);
  for (std::string number; std::getline (stream, number, ',');)
    numbers.push_back (apps::parseNumber<int> (
        "--neighbors", number, apps::Range::from (3).upTo (10'000)));
  return numbers;
}

bool
readOptions (int argc, const char* const* argv, TruthOptions& options)
{
  apps::CommandLine line (
      "pcl_ops_evaluate truth",
      "Tells how good the truth by region growing is: against exact truth where the "
      "data set\nhas it, and how many points it leaves without a plane.",
      PCL_OPS_VERSION);
  addDataOptions (line, options.data);
  line.addValue (
      "neighbors",
      "K,K,...",
      "neighbourhoods to try (15,30,60,100,150)",
      [&] (const std::string& text) { options.neighbors = numbersOf (text); });
  line.addNumber ("threads", "T", apps::Range::from (0), options.threads, "0: all (0)");
  return line.parse (argc, argv);
}

/** Sums over the clouds of a data set for one neighbourhood. */
struct GrownQuality {
  double clouds = 0, planes = 0, unlabelled = 0;
  double clouds_with_exact = 0, classification = 0, segmentation = 0, f_score = 0,
         exact_planes = 0;

  void
  add (const EvaluationCloud& cloud,
       const PlaneLabels& grown,
       const TruthParameters& truth)
  {
    const auto zeros =
        static_cast<std::size_t> (std::count (grown.begin(), grown.end(), 0u));
    clouds += 1;
    planes += static_cast<double> (planeIds (grown).size());
    unlabelled += apps::fraction (zeros, grown.size(), 0.0);
    if (!cloud.truth)
      return;
    ClassParameters classes;
    classes.up = cloud.up;
    const Metrics metrics =
        compareLabels (*cloud.cloud, truthOf (cloud, truth), grown, classes);
    clouds_with_exact += 1;
    classification += metrics.classification_accuracy;
    segmentation += metrics.segmentation_accuracy;
    f_score += metrics.at_50.f_score;
    exact_planes += static_cast<double> (metrics.truth_planes);
  }

  std::vector<std::string>
  row (int neighbors) const
  {
    const auto ofExact = [this] (double sum) {
      return clouds_with_exact > 0 ? sum / clouds_with_exact : NAN;
    };
    return {std::to_string (neighbors),
            decimal (clouds, 0),
            percent (unlabelled / clouds),
            decimal (planes / clouds, 1),
            decimal (ofExact (exact_planes), 1),
            percent (ofExact (classification)),
            percent (ofExact (segmentation)),
            decimal (ofExact (f_score), 3)};
  }
};

TextTable
qualityOf (const DataSet& data_set, const TruthOptions& options)
{
  std::map<int, GrownQuality> qualities;
  for (const CloudSource& source : data_set.clouds) {
    apps::inMemory (source.name, "give a smaller cloud", [&] {
      const EvaluationCloud cloud = source.load();
      for (const int neighbors : options.neighbors) {
        RegionGrowingParameters parameters = options.data.truth.growing;
        parameters.neighbors = neighbors;
        qualities[neighbors].add (
            cloud,
            growRegions (*cloud.cloud, parameters, options.threads),
            options.data.truth);
      }
    });
    std::cerr << data_set.name << ' ' << source.name << std::endl;
  }
  TextTable table{"Truth by region growing: " + data_set.name,
                  {"neighbours",
                   "clouds",
                   "no plane %",
                   "planes",
                   "exact planes",
                   "class. %",
                   "segm. %",
                   "F 0.5"},
                  {}};
  for (const auto& [neighbors, quality] : qualities)
    table.rows.push_back (quality.row (neighbors));
  return table;
}

} // namespace

int
truthCommand (int argc, const char* const* argv)
{
  TruthOptions options;
  if (!readOptions (argc, argv, options))
    return apps::ExitCode::done;
  for (const DataSet& data_set : dataSetsOf (options.data))
    std::cout << qualityOf (data_set, options);
  return apps::ExitCode::done;
}

} // namespace pcl_ops::evaluation
