// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <ostream>
#include <string>
#include <thread>

namespace pcl_ops::apps {

/** \brief Tells at which stage of a long work a program is, where its steps are too few
 * to count: a line each ten seconds, and none where all is done before. Without room
 * for one more thread it is silent. */
class StageLines {
public:
  /** \param[in] stream used by a thread of its own until \ref end
   * \param[in] between time from one line to the next */
  explicit StageLines (std::ostream& stream,
                       std::chrono::milliseconds between = std::chrono::seconds (10));
  StageLines (const StageLines&) = delete;
  StageLines&
  operator= (const StageLines&) = delete;
  ~StageLines();

  /** \brief From now on lines are about this stage. */
  void
  begin (std::string stage);

  /** \brief No more lines. */
  void
  end ();

private:
  using Clock = std::chrono::steady_clock;

  void
  writeLines ();

  std::ostream& stream_;
  std::chrono::milliseconds between_;
  Clock::time_point start_ = Clock::now();
  std::mutex mutex_;
  std::condition_variable has_ended_;
  std::string stage_;
  bool is_ended_ = false;
  std::thread thread_;
};

} // namespace pcl_ops::apps
