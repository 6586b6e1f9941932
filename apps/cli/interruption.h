// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>

namespace pcl_ops::apps {

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
