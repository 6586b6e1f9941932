// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "commands.h"
#include <common/program.h>

#include <functional>
#include <iostream>
#include <map>

namespace {

using namespace pcl_ops;

constexpr const char* program_name = "pcl_ops_evaluate";

constexpr const char* help =
    "pcl_ops_evaluate: compares plane detectors as the paper of OPS does\n"
    "(Sun & Mordohai, ICRA 2019)\n\n"
    "  pcl_ops_evaluate compare TRUTH RESULT   every metric for two labelled clouds\n"
    "  pcl_ops_evaluate run OUTPUT DATASET...  detectors over data sets\n"
    "  pcl_ops_evaluate report OUTPUT          tables and plots of a run's results\n"
    "  pcl_ops_evaluate pictures OUTPUT DATASET...  what they find, as pictures\n"
    "  pcl_ops_evaluate truth DATASET...       how good a truth region growing makes\n"
    "  pcl_ops_evaluate up DATASET...          how well the up axis is found\n"
    "  pcl_ops_evaluate detectors              the detectors a run can have\n"
    "\n"
    "pcl_ops_evaluate COMMAND --help says more.\n";

int
dispatch (int argc, const char* const* argv)
{
  using Command = std::function<int (int, const char* const*)>;
  const std::map<std::string, Command> commands{
      {"compare", evaluation::compareCommand},
      {"run", evaluation::runCommand},
      {"report", evaluation::reportCommand},
      {"pictures", evaluation::picturesCommand},
      {"truth", evaluation::truthCommand},
      {"up", evaluation::upCommand},
      {"detectors", evaluation::detectorsCommand},
  };
  const std::string name = argc > 1 ? argv[1] : "";
  if (name == "--help" || name == "-help" || name == "-h") {
    std::cout << help;
    return apps::kDone;
  }
  if (name == "--version" || name == "-version") {
    std::cout << program_name << ' ' << PCL_OPS_VERSION << '\n';
    return apps::kDone;
  }
  const auto command = commands.find (name);
  if (command == commands.end())
    throw apps::UsageError (name.empty() ? "command" : name,
                            name.empty() ? "is missing; see --help"
                                         : "is no command; see --help");
  return command->second (argc - 1, argv + 1);
}

} // namespace

int
main (int argc, char** argv)
{
  return apps::runProgram (program_name, [&] { return dispatch (argc, argv); });
}
