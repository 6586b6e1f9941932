// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "limited_run.h"

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstring>
#include <mutex>
#include <stdexcept>

namespace pcl_ops::evaluation {

namespace {

[[noreturn]] void
workAndEnd (const std::function<std::string()>& work, unsigned seconds, int pipe)
{
  std::signal (SIGALRM, SIG_DFL); // ends the process
  alarm (seconds);
  std::string bytes;
  int code = 0;
  try {
    bytes = work();
  }
  catch (const std::exception& error) {
    bytes = error.what();
    code = 1;
  }
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t written = write (pipe, bytes.data() + done, bytes.size() - done);
    if (written <= 0)
      _exit (1);
    done += static_cast<std::size_t> (written);
  }
  _exit (code);
}

std::string
readAll (int pipe)
{
  std::string bytes;
  std::array<char, 65536> part{};
  for (ssize_t count = 0; (count = read (pipe, part.data(), part.size())) > 0;)
    bytes.append (part.data(), static_cast<std::size_t> (count));
  return bytes;
}

/** What a detector's process hands over; the labels of the points are behind it. */
struct HandedOver {
  StageDurations durations;
  std::size_t planes_before_merging = 0;
};

} // namespace

std::optional<std::string>
runInChild (const std::function<std::string()>& work, unsigned seconds)
{
  static std::mutex mutex;
  std::unique_lock<std::mutex> lock (mutex); // no other child holds the end that writes
  std::array<int, 2> ends{};
  const pid_t child = pipe (ends.data()) == 0 ? fork() : -1;
  if (child == 0)
    workAndEnd (work, seconds, ends[1]);
  if (child < 0)
    throw std::runtime_error ("no process for it");
  close (ends[1]);
  lock.unlock();
  std::string bytes = readAll (ends[0]);
  close (ends[0]);
  int status = 0;
  if (waitpid (child, &status, 0) < 0)
    throw std::runtime_error ("no process for it");
  if (WIFSIGNALED (status) && WTERMSIG (status) == SIGALRM)
    return std::nullopt;
  if (WIFSIGNALED (status))
    throw std::runtime_error ("ended by signal " + std::to_string (WTERMSIG (status)));
  if (WEXITSTATUS (status) != 0)
    throw std::runtime_error (bytes);
  return bytes;
}

std::optional<DetectorRun>
runLimited (const Configuration& configuration,
            const XyzCloud::ConstPtr& cloud,
            const RunSettings& settings,
            unsigned seconds)
{
  if (!configuration.is_peer)
    return configuration.run (cloud, settings);
  const auto detect = [&] {
    const DetectorRun run = configuration.run (cloud, settings);
    const HandedOver handed_over{run.durations, run.planes_before_merging};
    std::string bytes (reinterpret_cast<const char*> (&handed_over),
                       sizeof handed_over);
    return bytes.append (reinterpret_cast<const char*> (run.labels.data()),
                         run.labels.size() * sizeof run.labels[0]);
  };
  const std::optional<std::string> bytes = runInChild (detect, seconds);
  if (!bytes)
    return std::nullopt;
  HandedOver handed_over;
  PlaneLabels labels ((bytes->size() - sizeof handed_over) / sizeof (std::uint32_t));
  std::memcpy (&handed_over, bytes->data(), sizeof handed_over);
  std::memcpy (labels.data(),
               bytes->data() + sizeof handed_over,
               bytes->size() - sizeof handed_over);
  return DetectorRun{labels, handed_over.planes_before_merging, handed_over.durations};
}

} // namespace pcl_ops::evaluation
