// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "interruption.h"

#include <atomic>
#include <csignal>
#include <cstdint>
#include <ctime>

namespace pcl_ops::apps {

namespace {

/** \brief Read by all threads; lock-free, as a signal handler needs it. */
std::atomic<int> noted_signal{0};
static_assert (std::atomic<int>::is_always_lock_free);

std::atomic<std::int64_t> noted_at{0};
static_assert (std::atomic<std::int64_t>::is_always_lock_free);

/** \brief [ms]; of the clocks that signal handlers may ask. */
std::int64_t
milliseconds ()
{
  timespec now{};
  ::clock_gettime (CLOCK_MONOTONIC, &now);
  return std::int64_t (1000) * now.tv_sec + now.tv_nsec / 1000000;
}

void
noteSignal (int signal)
{
  // What ends programs often signals twice: timeout the program and its group.
  constexpr std::int64_t same_wish = 500;
  if (noted_signal == 0) {
    noted_at = milliseconds();
    noted_signal = signal;
  }
  else if (milliseconds() - noted_at > same_wish) {
    std::signal (signal, SIG_DFL);
    std::raise (signal);
  }
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
    action.sa_flags = 0;
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
