// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "commands.h"

#include <cli/errors.h>
#include <cli/program.h>
#include <cli/similar_name.h>

#include <algorithm>
#include <iomanip>
#include <iostream>

namespace pcl_ops::evaluation {

using namespace apps;

namespace {

void
printHelp (const std::vector<Command>& commands)
{
  constexpr int width_of_calls = 28; // command and arguments [characters]
  std::cout << "Usage: pcl_ops_evaluate COMMAND [arguments] [options]\n"
               "Compares planes and labels as the paper of OPS does (Sun & Mordohai, "
               "ICRA 2019).\n"
               "\n"
               "Commands:\n";
  for (const Command& command : commands) {
    const std::string gap = command.arguments.empty() ? "" : " ";
    std::cout << "  " << std::left << std::setw (width_of_calls)
              << command.name + gap + command.arguments << ' ' << command.summary
              << '\n';
  }
  std::cout << "\n"
               "Options:\n"
               "  --help                       print this and exit, after COMMAND what "
               "it takes\n"
               "  --version                    print the version and exit\n";
}

/** Throws a UsageError that names a similar command if there is one. */
[[noreturn]] void
refuseUnknown (const std::string& name, const std::vector<Command>& commands)
{
  std::vector<std::string> names;
  for (const Command& command : commands)
    names.push_back (command.name);
  const std::string similar = similarName (name, names);
  throw UsageError (name,
                    "is no command; " + (similar.empty()
                                             ? "see --help"
                                             : "did you mean " + similar + "?"));
}

} // namespace

std::vector<Command>
commandsForResults ()
{
  return {{"compare",
           "TRUTH RESULT",
           "every metric for two labeled clouds",
           compareCommand},
          {"ground",
           "TRUTH RESULT",
           "how well planes tell the ground from what stands on it",
           groundCommand},
          {"planes",
           "A B",
           "which planes of two results are one, how far apart",
           planesCommand},
          {"track",
           "TRUTH RESULT",
           "how many planes keep their number in a sequence",
           trackCommand}};
}

int
runCommand (const std::vector<Command>& commands, int argc, const char* const* argv)
{
  const std::string name = argc > 1 ? argv[1] : "";
  if (name == "--help" || name == "-help" || name == "-h") {
    printHelp (commands);
    return ExitCode::done;
  }
  if (name == "--version" || name == "-version") {
    std::cout << "pcl_ops_evaluate " << PCL_OPS_VERSION << '\n';
    return ExitCode::done;
  }
  if (name.empty())
    throw UsageError ("command", "is missing; see --help");
  const auto command =
      std::find_if (commands.begin(), commands.end(), [&name] (const Command& known) {
        return known.name == name;
      });
  if (command == commands.end())
    refuseUnknown (name, commands);
  return command->run (argc - 1, argv + 1);
}

} // namespace pcl_ops::evaluation
