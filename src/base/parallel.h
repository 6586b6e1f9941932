// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <type_traits>
#include <vector>

namespace pcl_ops::internal {

/** \brief Returns how many threads can run at the same time, at least 1. */
std::size_t
availableProcessors ();

/** \brief Posts \p calls calls of a task to the worker threads, or one for each worker
 * if these are fewer, and returns at once. A call runs when a worker has time: perhaps
 * late, perhaps never. So the task, which is copied, has to own all that it uses. There
 * are as many workers as the largest \p calls so far, or as many as the system allows;
 * idle workers sleep.
 * \param[in] task must not throw */
void
callOnWorkers (std::size_t calls, const std::function<void()>& task);

/** \brief Calls \p body (begin, end) in parallel for consecutive pieces of the range
 * 0 .. size - 1. All parallel loops of the library use it. The pieces depend on
 * \p size and \p piece_size only: results per piece are the same for any number of
 * threads.
 * \param[in] threads largest number of threads; 0: one per available processor
 * \param[in] piece_size items per piece, 1 or more; the last piece may have fewer
 * \param[in] body if it throws, the exception is rethrown after all pieces are done */
void
parallelFor (unsigned threads,
             std::size_t size,
             std::size_t piece_size,
             const std::function<void (std::size_t begin, std::size_t end)>& body);

/** \brief Calls \p visit (i) for each i in 0 .. size - 1 by \ref parallelFor. */
template <typename Visit>
void
forEach (unsigned threads, std::size_t size, Visit&& visit)
{
  constexpr std::size_t items_per_piece = 1024; // chosen by hand, changes only the time
  parallelFor (
      threads, size, items_per_piece, [&] (std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
          visit (i);
      });
}

/** \brief Calls \p body (begin, end) for each piece as \ref parallelFor does.
 * \return a vector of the results of \p body, in the order of the pieces; they need a
 * default constructor */
template <typename Body>
auto
parallelPieces (unsigned threads, std::size_t size, std::size_t piece_size, Body&& body)
{
  using Result = decltype (body (size, size));
  static_assert (!std::is_same_v<Result, bool>, "elements of vector<bool> share bytes");
  std::vector<Result> results ((size + piece_size - 1) / piece_size);
  parallelFor (threads, size, piece_size, [&] (std::size_t begin, std::size_t end) {
    results[begin / piece_size] = body (begin, end);
  });
  return results;
}

} // namespace pcl_ops::internal
