// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "limited_run.h"

#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstring>
#include <new>
#include <stdexcept>

namespace pcl_ops::evaluation {

namespace {

/** Of what an exception says, with its end. */
constexpr std::size_t longest_problem = 200;

[[noreturn]] void
workAndEnd (const std::function<void()>& work, unsigned seconds, char* problem)
{
  std::signal (SIGALRM, SIG_DFL); // ends the process
  alarm (seconds);
  try {
    work();
    _exit (0);
  }
  catch (const std::exception& error) {
    std::strncpy (problem, error.what(), longest_problem - 1);
    _exit (1);
  }
}

/** What a detector's process hands over; the labels of the points are behind it. */
struct Answer {
  StageDurations durations;
  std::size_t planes_before_merging = 0;
};

} // namespace

SharedMemory::SharedMemory (std::size_t bytes)
: bytes_ (bytes)
, begin_ (
      mmap (nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0))
{
  if (begin_ == MAP_FAILED)
    throw std::bad_alloc();
}

SharedMemory::~SharedMemory() { munmap (begin_, bytes_); }

bool
runInChild (const std::function<void()>& work, unsigned seconds)
{
  const SharedMemory memory (longest_problem); // all zero
  auto* const problem = static_cast<char*> (memory.begin());
  const pid_t child = fork();
  if (child == 0)
    workAndEnd (work, seconds, problem);
  int status = 0;
  if (child < 0 || waitpid (child, &status, 0) < 0)
    throw std::runtime_error ("no process for it");
  if (WIFSIGNALED (status) && WTERMSIG (status) == SIGALRM)
    return false;
  if (WIFSIGNALED (status))
    throw std::runtime_error ("ended by signal " + std::to_string (WTERMSIG (status)));
  if (WEXITSTATUS (status) != 0)
    throw std::runtime_error (problem);
  return true;
}

std::optional<DetectorRun>
runLimited (const Configuration& configuration,
            const XyzCloud::ConstPtr& cloud,
            const RunSettings& settings,
            unsigned seconds)
{
  const SharedMemory memory (sizeof (Answer) + cloud->size() * sizeof (std::uint32_t));
  auto* const answer = new (memory.begin()) Answer;
  auto* const labels = reinterpret_cast<std::uint32_t*> (answer + 1);
  const bool is_done = runInChild (
      [&] {
        const DetectorRun run = configuration.run (cloud, settings);
        *answer = {run.durations, run.planes_before_merging};
        std::copy (run.labels.begin(), run.labels.end(), labels);
      },
      seconds);
  if (!is_done)
    return std::nullopt;
  return DetectorRun{{labels, labels + cloud->size()},
                     answer->planes_before_merging,
                     answer->durations};
}

} // namespace pcl_ops::evaluation
