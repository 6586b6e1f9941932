// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

namespace pcl_ops::apps {

enum ExitCode : int { done = 0, work_failed = 1, wrong_usage = 2 };

/** \brief What the program that \ref runProgram runs says about a problem: one line,
 * without its end. */
std::string
errorLine (std::string message);

/** \brief Puts such a line on stderr, in one piece; the program goes on. */
void
warn (const std::string& message);

/** \brief Runs the body of a program and turns what it throws into one line on stderr
 * and an exit code. Silences PCL's own console output, which would make it more than a
 * line, and lets a file that outgrows the user's limit be one that cannot be written
 * instead of the program's end. \param[in] name of the program, in front of the line
 * \param[in] body returns the exit code of a run that threw nothing \return the exit
 * code; work_failed if the standard output could not be written */
int
runProgram (const std::string& name, const std::function<int()>& body);

} // namespace pcl_ops::apps
