// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "limited_run.h"

#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <memory>
#include <new>
#include <stdexcept>

namespace pcl_ops::evaluation {

namespace {

/** What the child process hands over; the labels of the points are behind it. */
struct Answer {
  StageDurations durations;
  std::size_t planes_before_merging = 0;
  char problem[200] = "";
};

/** Memory of both processes. */
class SharedMemory {
public:
  explicit SharedMemory (std::size_t bytes)
  : bytes_ (bytes)
  , begin_ (mmap (
        nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0))
  {
    if (begin_ == MAP_FAILED)
      throw std::bad_alloc();
  }
  SharedMemory (const SharedMemory&) = delete;
  SharedMemory&
  operator= (const SharedMemory&) = delete;
  ~SharedMemory() { munmap (begin_, bytes_); }

  void*
  begin () const
  {
    return begin_;
  }

private:
  std::size_t bytes_;
  void* begin_;
};

/** In the child: \p answer and \p labels are what the parent sees. */
[[noreturn]] void
runAndEnd (const std::function<DetectorRun()>& run,
           unsigned seconds,
           Answer& answer,
           std::uint32_t* labels)
{
  std::signal (SIGALRM, SIG_DFL); // ends the process
  alarm (seconds);
  try {
    const DetectorRun done = run();
    answer.durations = done.durations;
    answer.planes_before_merging = done.planes_before_merging;
    std::copy (done.labels.begin(), done.labels.end(), labels);
    _exit (0);
  }
  catch (const std::exception& error) {
    const std::string problem = error.what();
    const std::size_t length = std::min (problem.size(), sizeof (answer.problem) - 1);
    std::copy_n (problem.begin(), length, answer.problem);
    _exit (1);
  }
}

} // namespace

std::optional<DetectorRun>
runLimited (const Configuration& configuration,
            const XyzCloud::ConstPtr& cloud,
            const RunSettings& settings,
            unsigned seconds)
{
  const SharedMemory memory (sizeof (Answer) + cloud->size() * sizeof (std::uint32_t));
  auto* const answer = new (memory.begin()) Answer;
  auto* const labels = reinterpret_cast<std::uint32_t*> (answer + 1);
  const pid_t child = fork();
  if (child == 0)
    runAndEnd (
        [&] { return configuration.run (cloud, settings); }, seconds, *answer, labels);
  int status = 0;
  if (child < 0 || waitpid (child, &status, 0) < 0)
    throw std::runtime_error ("no process for it");
  if (WIFSIGNALED (status) && WTERMSIG (status) == SIGALRM)
    return std::nullopt;
  if (WIFSIGNALED (status))
    throw std::runtime_error ("ended by signal " + std::to_string (WTERMSIG (status)));
  if (WEXITSTATUS (status) != 0)
    throw std::runtime_error (answer->problem);
  return DetectorRun{{labels, labels + cloud->size()},
                     answer->planes_before_merging,
                     answer->durations};
}

} // namespace pcl_ops::evaluation
