// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "interruption.h"

#include <atomic>
#include <csignal>

namespace pcl_ops::apps {

namespace {

/** \brief Read by all threads; lock-free, as a signal handler needs it. */
std::atomic<int> noted_signal{0};
static_assert (std::atomic<int>::is_always_lock_free);

void
noteSignal (int signal)
{
  noted_signal = signal;
}

} // namespace

void
noteInterruptions ()
{
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction action {};
    if (sigaction (signal, nullptr, &action) != 0 || action.sa_handler == SIG_IGN)
      continue;
    action.sa_handler = noteSignal;
    // Without SA_RESTART: a read that waits for input returns.
    action.sa_flags = static_cast<int> (SA_RESETHAND);
    sigaction (signal, &action, nullptr);
  }
}

bool
isInterrupted ()
{
  return noted_signal != 0;
}

void
stopIfInterrupted ()
{
  if (isInterrupted())
    throw Interrupted();
}

void
ignoreClosedPipes ()
{
  std::signal (SIGPIPE, SIG_IGN);
}

void
endAsInterrupted ()
{
  if (!isInterrupted())
    return;
  std::signal (noted_signal, SIG_DFL);
  std::raise (noted_signal);
}

} // namespace pcl_ops::apps
