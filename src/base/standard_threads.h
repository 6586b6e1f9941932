// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <thread>
#include <vector>

namespace pcl_ops::internal {

/** \brief Calls \p work with 0 .. \p pieces - 1 by threads of the standard library, for
 * the thread sanitizer, which does not see how those of OpenMP wait for each other.
 * \param[in] threads number of threads; 0: a few
 * \param[in] work called concurrently; must not throw */
template <typename Work>
void
forPiecesByStandardThreads (unsigned threads, std::int64_t pieces, const Work& work)
{
  constexpr std::int64_t few = 4, most = 16;
  const std::int64_t wanted = threads ? std::min<std::int64_t> (threads, most) : few;
  std::atomic<std::int64_t> next{0};
  const auto take_turns = [&] {
    for (std::int64_t piece; (piece = next++) < pieces;)
      work (piece);
  };
  std::vector<std::thread> others;
  for (std::int64_t i = 1; i < std::min (wanted, pieces); ++i)
    others.emplace_back (take_turns);
  take_turns();
  for (std::thread& other : others)
    other.join();
}

} // namespace pcl_ops::internal
