// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "peak_memory.h"

#include "cloud_measures.h"
#include <sys/wait.h>
#include <unistd.h>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <algorithm>
#include <fstream>
#include <functional>

namespace pcl_ops::benchmark {

namespace {

using evaluation::XyzCloud;

/** A line of /proc/self/status in bytes; NaN if there is none. */
double
statusBytes (const std::string& name)
{
  constexpr double bytes_per_kilobyte = 1024.0;
  std::ifstream status ("/proc/self/status");
  for (std::string line; std::getline (status, line);)
    if (line.rfind (name + ":", 0) == 0)
      return bytes_per_kilobyte * std::stod (line.substr (name.size() + 1));
  return std::numeric_limits<double>::quiet_NaN();
}

/** Freed memory that the process keeps would hide what is allocated next. */
void
giveBackFreedMemory ()
{
#ifdef __GLIBC__
  malloc_trim (0);
#endif
}

double
growthOf (const std::function<void()>& work)
{
  giveBackFreedMemory();
  // "5" sets the peak back to what is resident now (proc(5)).
  std::ofstream ("/proc/self/clear_refs") << "5";
  const double before = statusBytes ("VmRSS");
  work();
  return statusBytes ("VmHWM") - before;
}

/** The number that a child process comes to; NaN if it does not. */
double
inChildProcess (const std::function<double()>& compute)
{
  double result = std::numeric_limits<double>::quiet_NaN();
  int ends[2];
  if (pipe (ends) != 0)
    return result;
  const pid_t child = fork();
  if (child == 0) {
    try {
      const double number = compute();
      _exit (write (ends[1], &number, sizeof (number)) == sizeof (number) ? 0 : 1);
    }
    catch (...) {
      _exit (1);
    }
  }
  close (ends[1]);
  if (child > 0) {
    double number = 0.0;
    if (read (ends[0], &number, sizeof (number)) == sizeof (number))
      result = number;
    waitpid (child, nullptr, 0);
  }
  close (ends[0]);
  return result;
}

} // namespace

PeakMemory
peakMemoryOn (const XyzCloud::ConstPtr& cloud,
              const evaluation::Configuration& detector)
{
  // The pages of the program itself are resident once a small cloud has used them.
  constexpr std::size_t small = 5000;
  const XyzCloud::Ptr few (new XyzCloud);
  const std::size_t stride = std::max<std::size_t> (1, cloud->size() / small);
  for (std::size_t i = 0; i < cloud->size(); i += stride)
    few->push_back ((*cloud)[i]);

  PeakMemory peak;
  peak.points = cloud->size();
  peak.cloud_bytes = static_cast<double> (cloud->size() * sizeof (pcl::PointXYZ));
  giveBackFreedMemory();
  const auto detect = [&] (const XyzCloud::ConstPtr& any) {
    detector.run (any, Eigen::Vector3d::UnitZ(), MeasureParameters().seed);
  };
  peak.extra_bytes = inChildProcess ([&] {
    detect (few);
    return growthOf ([&] { detect (cloud); });
  });
  return peak;
}

PeakMemory
peakMemoryOn (const XyzCloud::ConstPtr& cloud)
{
  return peakMemoryOn (cloud,
                       evaluation::selectConfigurations (default_preset).front());
}

} // namespace pcl_ops::benchmark
