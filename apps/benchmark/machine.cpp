// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "machine.h"

#include <pcl/pcl_config.h>

#include <cli/parallel.h>
#include <evaluation/detectors/timed.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <fstream>
#include <limits>
#include <numeric>
#include <thread>

namespace pcl_ops::benchmark {

namespace {

std::string
cpuModel ()
{
  std::ifstream info ("/proc/cpuinfo");
  for (std::string line; std::getline (info, line);)
    if (line.rfind ("model name", 0) == 0)
      return line.substr (line.find (':') + 2);
  return "unknown CPU";
}

std::string
compilerAndFlags ()
{
#if defined(__clang__)
  return "clang " __clang_version__ " " PCL_OPS_COMPILER_FLAGS;
#elif defined(__GNUC__)
  return "g++ " __VERSION__ " " PCL_OPS_COMPILER_FLAGS;
#else
  return "unknown compiler";
#endif
}

/** Independent streams, so that one thread keeps a core's arithmetic units busy: of
 * one stream that waits for its own results, two threads could share a core unnoticed.
 * Knuth's constants of a linear congruential generator. */
std::uint64_t
plainArithmetic ()
{
  constexpr int rounds = 10'000'000;
  std::array<std::uint64_t, 8> streams{1, 2, 3, 4, 5, 6, 7, 8};
  for (int round = 0; round < rounds; ++round)
    for (std::uint64_t& stream : streams)
      stream = stream * 6364136223846793005u + 1442695040888963407u;
  return std::accumulate (streams.begin(), streams.end(), std::uint64_t (0));
}

double
arithmeticTime (unsigned threads, std::size_t runs)
{
  double best = std::numeric_limits<double>::infinity();
  // Keeps the compiler from leaving out what nobody reads.
  std::atomic<std::uint64_t> result{0};
  for (std::size_t run = 0; run < runs; ++run) {
    double time = 0.0;
    evaluation::timed (time, [&] {
      apps::runInParallel (
          threads, threads, [&] (std::size_t) { result += plainArithmetic(); });
    });
    best = std::min (best, time);
  }
  return best;
}

} // namespace

Machine
describeMachine ()
{
  return {cpuModel(),
          std::thread::hardware_concurrency(),
          compilerAndFlags(),
          PCL_VERSION_PRETTY};
}

double
arithmeticSpeedup (std::size_t runs)
{
  return 2.0 * arithmeticTime (1, runs) / arithmeticTime (2, runs);
}

} // namespace pcl_ops::benchmark
