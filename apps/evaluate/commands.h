// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace pcl_ops::evaluation {

/** A command of pcl_ops_evaluate; each has a --help of its own. */
struct Command {
  std::string name;
  /** As in the help: "TRUTH RESULT". */
  std::string arguments;
  std::string summary;
  /** Runs the command.
   * \param[in] argv name of the command, then its arguments and options
   * \return the exit code */
  int (*run) (int argc, const char* const* argv);
};

int
compareCommand (int argc, const char* const* argv);

int
groundCommand (int argc, const char* const* argv);

int
planesCommand (int argc, const char* const* argv);

int
trackCommand (int argc, const char* const* argv);

/** Returns the commands that read results of users. lab/evaluation adds commands that
 * run detectors. */
std::vector<Command>
commandsForResults ();

/** Runs the command that the first argument of the program names.
 * \param[in] argv name of the program, then its arguments
 * \return the exit code
 * \throw apps::UsageError if the command is missing or unknown */
int
runCommand (const std::vector<Command>& commands, int argc, const char* const* argv);

} // namespace pcl_ops::evaluation
