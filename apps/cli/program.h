// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

namespace pcl_ops::apps {

/** \brief What programs return to the shell. */
enum ExitCode : int { done = 0, work_failed = 1, wrong_usage = 2 };

/** \brief Returns the line that \ref runProgram prints about a problem: the name of the
 * program, ": " and the message, without a line break. */
std::string
errorLine (std::string message);

/** \brief Prints \ref errorLine on stderr in one piece; the program goes on. */
void
warn (const std::string& message);

/** \brief Runs the body of a program, which returns the exit code. An exception, or a
 * standard output that cannot be written, becomes one line on stderr and an exit code.
 * PCL prints nothing meanwhile. If a file exceeds the user's size limit (SIGXFSZ),
 * writing fails, but the program is not killed.
 * \param[in] name of the program, for messages
 * \return the exit code */
int
runProgram (const std::string& name, const std::function<int()>& body);

/** \brief Is thrown to end the program after a signal of the user. Outputs that were
 * complete before stay. */
struct Interrupted : std::runtime_error {
  Interrupted()
  : std::runtime_error ("interrupted: no file is half-written; run it again")
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
