// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program.h"

#include <pcl/console/print.h>

#include "errors.h"
#include "text.h"
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdint>
#include <ctime>
#include <iostream>

namespace pcl_ops::apps {

namespace {

/** \brief The signal that was noted, 0 for none. All threads read it; it is lock-free,
 * as a signal handler needs. */
std::atomic<int> noted_signal{0};
static_assert (std::atomic<int>::is_always_lock_free);

/** \brief When \ref noted_signal was noted, as \ref monotonicTime [ms]. */
std::atomic<std::int64_t> noted_at{0};
static_assert (std::atomic<std::int64_t>::is_always_lock_free);

/** \brief Returns the time [ms] of a monotonic clock that a signal handler may read. */
std::int64_t
monotonicTime ()
{
  timespec now{};
  ::clock_gettime (CLOCK_MONOTONIC, &now);
  constexpr std::int64_t milliseconds_in_second = 1000;
  constexpr std::int64_t nanoseconds_in_millisecond = 1000000;
  return milliseconds_in_second * now.tv_sec + now.tv_nsec / nanoseconds_in_millisecond;
}

/** \brief The signal handler: see \ref noteInterruptions. */
void
noteSignal (int signal)
{
  // Programs such as timeout signal twice: the program, then its process group. The
  // second signal is not one more from the user, who waits longer to see an effect.
  constexpr std::int64_t max_between_both = 500; // [ms], chosen by hand
  if (noted_signal == 0) {
    // noted_at is set first: once noted_signal is set, both are valid.
    noted_at = monotonicTime();
    noted_signal = signal;
  }
  else if (monotonicTime() - noted_at > max_between_both) {
    std::signal (signal, SIG_DFL);
    std::raise (signal);
  }
}

/** \brief The name that messages begin with. */
std::string running_program;

/** \brief Opens /dev/null for each standard stream that is closed. Otherwise the next
 * file that the program opens would get the number of the stream, and printed text
 * would be written into that file.
 * \return whether the standard output was open */
bool
holdClosedStreams ()
{
  bool has_output = true;
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl (stream, F_GETFD) == -1) {
      // open() returns the lowest free number, which is that of this stream. With the
      // wrong access mode, using the stream fails as it would if it were closed.
      const int wrong_mode = stream == STDIN_FILENO ? O_WRONLY : O_RDONLY;
      static_cast<void> (::open ("/dev/null", wrong_mode));
      has_output = has_output && stream != STDOUT_FILENO;
    }
  return has_output;
}

/** \brief Prints a message after all that the program has printed so far.
 * \return \p code */
int
fail (const std::string& message, ExitCode code)
{
  std::cout.flush();
  warn (message);
  return code;
}

} // namespace

std::string
errorLine (std::string message)
{
  return running_program + ": " + oneLine (std::move (message));
}

void
warn (const std::string& message)
{
  std::cerr << errorLine (message) + "\n" << std::flush;
}

int
runProgram (const std::string& name, const std::function<int()>& body)
{
  running_program = name;
  std::signal (SIGXFSZ, SIG_IGN);
  pcl::console::setVerbosityLevel (pcl::console::L_ALWAYS);
  const bool has_output = holdClosedStreams();
  try {
    const int code = body();
    if (!std::cout.flush())
      throw WorkError ("standard output",
                       has_output
                           ? "cannot be written; is its disk full?"
                           : "is closed; give >/dev/null or --quiet to go without");
    return code;
  }
  catch (const UsageError& error) {
    return fail (error.what(), ExitCode::wrong_usage);
  }
  catch (const std::bad_alloc&) {
    return fail ("not enough memory; try a smaller cloud", ExitCode::work_failed);
  }
  catch (const std::exception& error) {
    const std::string reason = error.what();
    // libstdc++ names this function if the user's locale does not exist or memory is
    // short.
    const bool is_about_locale =
        reason.find ("_S_create_c_locale") != std::string::npos;
    return fail (is_about_locale ? "LANG cannot be set up: not enough memory, or it "
                                   "is none; try a smaller cloud or LANG=C"
                                 : reason,
                 ExitCode::work_failed);
  }
}

void
noteInterruptions ()
{
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction action {};
    if (sigaction (signal, nullptr, &action) != 0 || action.sa_handler == SIG_IGN)
      continue;
    action.sa_handler = noteSignal;
    // Without SA_RESTART a signal ends a read that waits for input.
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
