// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/parallel.h"

#include "base/worker_threads.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>

namespace pcl_ops::internal {

namespace {

using PieceBody = std::function<void (std::size_t, std::size_t)>;

/** \brief The pieces of one call, which whoever has time takes in turn. */
class Pieces {
public:
  /** \param[in] body used until all pieces are done */
  Pieces (std::size_t size, std::size_t grain, const PieceBody& body)
  : size_ (size), grain_ (grain), number_ ((size + grain - 1) / grain), body_ (body)
  {}

  std::size_t
  number () const
  {
    return number_;
  }

  /** \brief Does pieces until all have been taken. */
  void
  takeTurns ()
  {
    for (std::size_t piece; (piece = next_++) < number_;)
      work (piece);
  }

  /** \brief Waits for those that others have taken, and throws what one has thrown. */
  void
  waitForOthers ()
  {
    std::unique_lock<std::mutex> lock (guard_);
    all_done_.wait (lock, [this] { return done_ == number_; });
    if (thrown_)
      std::rethrow_exception (thrown_);
  }

private:
  void
  work (std::size_t piece)
  {
    std::exception_ptr thrown;
    try {
      body_ (piece * grain_, std::min (size_, (piece + 1) * grain_));
    }
    catch (...) {
      thrown = std::current_exception();
    }
    const std::lock_guard<std::mutex> lock (guard_);
    if (thrown)
      thrown_ = thrown;
    if (++done_ == number_)
      all_done_.notify_one();
  }

  std::size_t size_, grain_, number_;
  const PieceBody& body_;
  std::atomic<std::size_t> next_{0};
  std::mutex guard_;
  std::condition_variable all_done_;
  std::size_t done_ = 0;
  std::exception_ptr thrown_;
};

/** \brief How many other threads to call. */
std::size_t
helpersFor (unsigned threads, std::size_t pieces)
{
  // More than these only cost.
  constexpr std::size_t most = 256;
  const std::size_t wanted = threads ? threads : availableProcessors();
  return std::min ({wanted, pieces, most}) - 1;
}

} // namespace

void
parallelFor (unsigned threads,
             std::size_t size,
             std::size_t grain,
             const PieceBody& body)
{
  if (size == 0)
    return;
  // Shared with helpers that come when all is done: nobody waits for a thread that the
  // system has no processor for.
  const auto pieces = std::make_shared<Pieces> (size, grain, body);
  if (const std::size_t helpers = helpersFor (threads, pieces->number()))
    callOnWorkers (helpers, [pieces] { pieces->takeTurns(); });
  pieces->takeTurns();
  pieces->waitForOthers();
}

} // namespace pcl_ops::internal
