// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_ops/parallel.h>

#ifdef _OPENMP
#include <omp.h>
#endif

#include <algorithm>
#include <cstdint>

namespace pcl_ops {

void
parallelFor (unsigned threads,
             std::size_t size,
             std::size_t grain,
             const std::function<void (std::size_t, std::size_t)>& body)
{
  const auto pieces = static_cast<std::int64_t> ((size + grain - 1) / grain);
#ifdef _OPENMP
  const int wanted = threads ? static_cast<int> (threads) : omp_get_num_procs ();
#pragma omp parallel for schedule(dynamic) num_threads(wanted)                         \
    if (wanted > 1 && pieces > 1)
#else
  (void)threads;
#endif
  for (std::int64_t piece = 0; piece < pieces; ++piece) {
    const std::size_t begin = static_cast<std::size_t> (piece) * grain;
    body (begin, std::min (size, begin + grain));
  }
}

} // namespace pcl_ops
