// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

namespace pcl_ops::apps {

/** \brief What programs return to the shell. */
enum ExitCode : int { done = 0, work_failed = 1, wrong_usage = 2 };

/** \brief Returns the line that \ref runProgram prints about a problem, "program:
 * message", without a line break. */
std::string
errorLine (std::string message);

/** \brief Prints \ref errorLine on stderr in one piece; the program goes on. */
void
warn (const std::string& message);

/** \brief Runs the body of a program, which returns the exit code. Exceptions, and a
 * standard output that cannot be written, become one line on stderr and an exit code.
 * Silences PCL's console. A file that exceeds the user's size limit (SIGXFSZ) makes
 * writing fail and does not end the program. */
int
runProgram (const std::string& name, const std::function<int()>& body);

/** \brief The user wants the program to end. */
struct Interrupted : std::runtime_error {
  Interrupted() : std::runtime_error ("interrupted: nothing was written; run it again")
  {}
};

/** \brief Installs signal handlers: the first Ctrl-C, termination or closed terminal is
 * noted for \ref isInterrupted. A further signal more than half a second later ends the
 * program as by default. Signals that are ignored stay ignored. */
void
noteInterruptions ();

/** \brief Lets the program go on after the reader of its output has closed the pipe
 * (SIGPIPE). */
void
ignoreClosedPipes ();

/** \brief Whether a signal was noted. */
bool
isInterrupted ();

/** \throws Interrupted if \ref isInterrupted returns true */
void
stopIfInterrupted ();

/** \brief Ends the program by the signal that was noted, if any, so that a shell loop
 * around it stops, too. */
void
endAsInterrupted ();

} // namespace pcl_ops::apps
