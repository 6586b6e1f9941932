// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detector_run.h"

#include <boost/interprocess/anonymous_shared_memory.hpp>

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstring>
#include <stdexcept>

namespace pcl_ops::evaluation {

namespace {

/** What a detector's process hands over; the labels of the points are behind it. */
struct HandedOver {
  StageDurations durations;
  std::size_t planes_before_merging = 0;
};

} // namespace

bool
runInChild (const std::function<void()>& work, unsigned seconds)
{
  constexpr std::size_t size_of_message = 4096;
  const auto memory = boost::interprocess::anonymous_shared_memory (size_of_message);
  char* const message = static_cast<char*> (memory.get_address()); // all zero
  const pid_t child = fork();
  if (child == 0) {
    std::signal (SIGALRM, SIG_DFL); // ends the process
    alarm (seconds);
    try {
      work();
      _exit (0);
    }
    catch (const std::exception& error) {
      std::strncpy (message, error.what(), size_of_message - 1);
      _exit (1);
    }
  }
  int status = 0;
  if (child < 0 || waitpid (child, &status, 0) < 0)
    throw std::runtime_error ("no process for it");
  if (WIFSIGNALED (status) && WTERMSIG (status) == SIGALRM)
    return false;
  if (WIFSIGNALED (status))
    throw std::runtime_error ("ended by signal " + std::to_string (WTERMSIG (status)));
  if (WEXITSTATUS (status) != 0)
    throw std::runtime_error (message);
  return true;
}

std::optional<DetectorRun>
runLimited (const Configuration& configuration,
            const XyzCloud::ConstPtr& cloud,
            const RunSettings& settings,
            unsigned seconds)
{
  if (!configuration.is_peer)
    return configuration.run (cloud, settings);
  const auto memory = boost::interprocess::anonymous_shared_memory (
      sizeof (HandedOver) + cloud->size() * sizeof (std::uint32_t));
  auto* const handed_over = static_cast<HandedOver*> (memory.get_address());
  auto* const labels = reinterpret_cast<std::uint32_t*> (handed_over + 1);
  const auto detect = [&] {
    const DetectorRun run = configuration.run (cloud, settings);
    *handed_over = {run.durations, run.planes_before_merging};
    std::copy (run.labels.begin(), run.labels.end(), labels);
  };
  if (!runInChild (detect, seconds))
    return std::nullopt;
  return DetectorRun{{labels, labels + cloud->size()},
                     handed_over->planes_before_merging,
                     handed_over->durations};
}

} // namespace pcl_ops::evaluation
