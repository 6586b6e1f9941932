// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "commands.h"
#include <cli/command_line.h>
#include <cli/errors.h>
#include <cli/program.h>
#include <evaluation/experiments/edge_accuracy.h>

#include <iostream>

namespace pcl_ops::evaluation {

int
edgesCommand (int argc, const char* const* argv)
{
  std::vector<std::string> texts;
  Eigen::Vector3f up = Eigen::Vector3f::UnitZ();
  apps::CommandLine line (
      "pcl_ops_evaluate edges",
      "Tells how well it is found where planes meet: compares the edges and corners\n"
      "of planes found by the default preset with those of the true planes, by "
      "length.\n"
      "The same are those within 5 cm. Wall edges are of a horizontal and a vertical\n"
      "plane, 1 m and longer.",
      PCL_OPS_VERSION);
  line.addArguments ("DATASET", texts, data_set_help);
  line.addUpAxis (up, "against gravity in clouds; camera: 0,-1,0 (0,0,1)");
  if (!line.parse (argc, argv))
    return apps::ExitCode::done;
  std::vector<EdgeScores> all;
  for (const DataSet& data_set : dataSetsOf (texts, up)) {
    EdgeScores of_set{data_set.name, {}};
    for (const CloudSource& source : data_set.clouds) {
      apps::inMemory (source.name, "give a smaller cloud", [&] {
        const EvaluationCloud cloud = source.load();
        if (!cloud.truth)
          throw apps::WorkError (source.name, "has no true labels; give another cloud");
        addScore (findBothEdges (cloud), of_set.score);
      });
      std::cerr << data_set.name << ' ' << source.name << std::endl;
    }
    all.push_back (of_set);
  }
  std::cout << edgeTable (all);
  return apps::ExitCode::done;
}

} // namespace pcl_ops::evaluation
