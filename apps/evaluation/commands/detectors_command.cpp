// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detectors_command.h"

#include <cli/command_line.h>
#include <cli/program.h>
#include <evaluation/detectors/detectors.h>

#include <iostream>

namespace pcl_ops::evaluation {

int
detectorsCommand (int argc, const char* const* argv)
{
  apps::CommandLine line ("pcl_ops_evaluate detectors",
                          "Lists the configurations a run can have and their groups.",
                          PCL_OPS_VERSION);
  if (!line.parse (argc, argv))
    return apps::ExitCode::done;
  for (const Configuration& configuration : allConfigurations()) {
    std::cout << configuration.name;
    for (const std::string& group : configuration.groups)
      std::cout << ' ' << group;
    std::cout << '\n';
  }
  return apps::ExitCode::done;
}

} // namespace pcl_ops::evaluation
