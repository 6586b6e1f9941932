// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace pcl_ops::internal {

/** \brief How many threads can run at the same time. */
std::size_t
availableProcessors ();

/** \brief Has a task, which must not throw, called by up to so many other threads, each
 * when it has time: after this has returned, and perhaps never. The threads are started
 * when first needed, fewer where the system starts no more, and sleep in between. */
void
callOnWorkers (std::size_t number, const std::function<void()>& task);

/** \brief Calls \p body (begin, end) for pieces of 0 .. size - 1 that cover it once:
 * the only place of the library that knows threads. The pieces depend on \p size and \p
 * grain alone, so what a body computes per piece is the same for any thread count.
 * \param[in] threads 0: as many as the machine has; fewer where the system starts no more
 * \param[in] grain items per piece, 1 or more
 * \param[in] body what it throws is thrown on after the other pieces are done */
void
parallelFor (unsigned threads,
             std::size_t size,
             std::size_t grain,
             const std::function<void (std::size_t begin, std::size_t end)>& body);

/** \brief Calls \p visit (i) for all of 0 .. size - 1, as \ref parallelFor does. */
template <typename Visit>
void
forEach (unsigned threads, std::size_t size, Visit&& visit)
{
  constexpr std::size_t at_once = 1024;
  parallelFor (threads, size, at_once, [&] (std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      visit (i);
  });
}

/** \brief What \p body (begin, end) returns for each piece, in the order of the pieces;
 * the rest as \ref parallelFor. */
template <typename Body>
auto
parallelChunks (unsigned threads, std::size_t size, std::size_t grain, Body&& body)
{
  std::vector<decltype (body (size, size))> pieces ((size + grain - 1) / grain);
  parallelFor (threads, size, grain, [&] (std::size_t begin, std::size_t end) {
    pieces[begin / grain] = body (begin, end);
  });
  return pieces;
}

} // namespace pcl_ops::internal
