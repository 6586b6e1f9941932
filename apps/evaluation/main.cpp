// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cli/errors.h>
#include <cli/program.h>
#include <evaluation/commands/commands.h>

#include <iostream>
#include <map>

namespace {

using namespace pcl_ops;

constexpr const char* program_name = "pcl_ops_evaluate";

constexpr const char* help =
    "Usage: pcl_ops_evaluate COMMAND [arguments] [options]\n"
    "Compares plane detectors as the paper of OPS does (Sun & Mordohai, ICRA 2019).\n"
    "\n"
    "Commands:\n"
    "  compare TRUTH RESULT         every metric for two labeled clouds\n"
    "  planes A B                   which planes of two results are one, how far "
    "apart\n"
    "  track TRUTH RESULT           how many planes keep their number in a sequence\n"
    "  run OUTPUT DATASET...        detectors over data sets\n"
    "  edges DATASET...             how well it is found where planes meet\n"
    "  detectors                    the detectors a run can have\n"
    "\n"
    "Options:\n"
    "  --help                       print this and exit, after COMMAND what it takes\n"
    "  --version                    print the version and exit\n";

int
dispatch (int argc, const char* const* argv)
{
  const std::map<std::string, evaluation::Command*> commands{
      {"compare", evaluation::compareCommand},
      {"planes", evaluation::planesCommand},
      {"track", evaluation::trackCommand},
      {"run", evaluation::runCommand},
      {"edges", evaluation::edgesCommand},
      {"detectors", evaluation::detectorsCommand},
  };
  const std::string name = argc > 1 ? argv[1] : "";
  if (name == "--help" || name == "-help" || name == "-h") {
    std::cout << help;
    return apps::ExitCode::done;
  }
  if (name == "--version" || name == "-version") {
    std::cout << program_name << ' ' << PCL_OPS_VERSION << '\n';
    return apps::ExitCode::done;
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
