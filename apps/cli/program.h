// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

namespace pcl_ops::apps {

enum ExitCode : int { done = 0, work_failed = 1, wrong_usage = 2 };

/** \brief What \ref runProgram says about a problem: one line, without its end. */
std::string
errorLine (std::string message);

/** \brief Puts such a line on stderr, in one piece; the program goes on. */
void
warn (const std::string& message);

/** \brief Runs the body of a program, which returns the exit code, and turns what it
 * throws, or that the standard output cannot be written, into one line on stderr and an
 * exit code. Silences PCL's console, and lets a file that outgrows the user's limit be
 * one that cannot be written instead of the program's end. */
int
runProgram (const std::string& name, const std::function<int()>& body);

struct Interrupted : std::runtime_error {
  Interrupted() : std::runtime_error ("interrupted: nothing was written; run it again")
  {}
};

/** \brief From now on the first Ctrl-C, termination or closed terminal is noted for
 * \ref isInterrupted, and one more than half a second later ends the program as ever.
 * Signals that are ignored stay so. */
void
noteInterruptions ();

/** \brief Lets the program go on where nobody reads what it prints any longer. */
void
ignoreClosedPipes ();

bool
isInterrupted ();

/** \throws Interrupted if it is */
void
stopIfInterrupted ();

/** \brief Ends the program by the signal that was noted, if one was, so that a loop of
 * a shell stops, too. */
void
endAsInterrupted ();

} // namespace pcl_ops::apps
