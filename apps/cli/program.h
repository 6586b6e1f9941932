// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <stdexcept>
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

struct Interrupted : std::runtime_error {
  Interrupted() : std::runtime_error ("interrupted: nothing was written; run it again")
  {}
};

/** \brief Lets the program end tidily on Ctrl-C, a termination or a closed terminal:
 * from now on the first of these signals is noted for \ref isInterrupted, and one that
 * comes more than half a second later ends the program as ever. Signals that are
 * ignored stay so. */
void
noteInterruptions ();

/** \brief Lets the program go on where nobody reads what it prints any longer. */
void
ignoreClosedPipes ();

bool
isInterrupted ();

/** \brief \throws Interrupted if the program should stop */
void
stopIfInterrupted ();

/** \brief Ends the program by the signal that was noted, so that a shell sees it
 * (130 after Ctrl-C) and a loop in it stops, too. Does nothing if none was. */
void
endAsInterrupted ();

} // namespace pcl_ops::apps
