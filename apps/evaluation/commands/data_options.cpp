// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "data_options.h"

#include <evaluation/data/data_sets.h>

namespace pcl_ops::evaluation {

namespace {

constexpr double most_neighbors = 10'000;

} // namespace

void
addDataOptions (apps::CommandLine& line, DataOptions& options)
{
  line.addArguments ("DATASET", options.data_sets, 1, data_set_help);
  line.addDirection ("up", options.up, "direction against gravity of clouds: (0,0,1)");
  line.addText ("cache",
                "FOLDER",
                options.truth.cache_folder,
                "where grown truth is kept (folder truth of the output)");
  line.addNumber ("truth-neighbors",
                  "K",
                  apps::Range::from (3).upTo (most_neighbors),
                  options.truth.growing.neighbors,
                  "neighbourhood of grown truth (100)");
  line.addNumber ("min-plane-points",
                  "N",
                  apps::Range::from (0),
                  options.truth.min_points,
                  "true planes with fewer points are none (50)");
}

std::vector<DataSet>
dataSetsOf (const DataOptions& options)
{
  std::vector<DataSet> data_sets;
  for (const std::string& text : options.data_sets)
    data_sets.push_back (dataSetOf (text, options.up.cast<double>().normalized()));
  return data_sets;
}

} // namespace pcl_ops::evaluation
