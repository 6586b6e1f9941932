// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "peak_memory.h"

#include "measures.h"
#include <evaluation/detectors/limited_run.h>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <algorithm>
#include <cstring>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <string>

namespace pcl_ops::benchmark {

namespace {

/** A line of /proc/self/status [byte]; NaN if there is none. */
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

/** By how much the resident memory grows at its peak while something is done [byte]. */
double
growthOf (const std::function<void()>& work)
{
#ifdef __GLIBC__
  malloc_trim (0); // freed memory that is kept would hide what is allocated next
#endif
  // "5" sets the peak back to what is resident now (proc(5)).
  std::ofstream ("/proc/self/clear_refs") << "5";
  const double before = statusBytes ("VmRSS");
  work();
  return statusBytes ("VmHWM") - before;
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
  const auto detect = [&] (const XyzCloud::ConstPtr& any) { detector.run (any, {}); };
  double growth = std::numeric_limits<double>::quiet_NaN();
  const auto measure = [&] {
    detect (few);
    const double grown = growthOf ([&] { detect (cloud); });
    return std::string (reinterpret_cast<const char*> (&grown), sizeof grown);
  };
  try {
    std::memcpy (
        &growth, evaluation::runInChild (measure, 0).value().data(), sizeof growth);
  }
  catch (const std::runtime_error&) { // the number stays NaN
  }
  return {cloud->size(),
          static_cast<double> (cloud->size() * sizeof (pcl::PointXYZ)),
          growth};
}

PeakMemory
peakMemoryOn (const XyzCloud::ConstPtr& cloud)
{
  return peakMemoryOn (cloud,
                       evaluation::selectConfigurations (default_preset).front());
}

} // namespace pcl_ops::benchmark
