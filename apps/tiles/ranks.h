// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace pcl_ops::apps {

/** \brief The processes that mpirun started to do one run together; one, rank 0, where
 * nobody did or this build is without MPI. */
class Ranks {
public:
  Ranks();
  Ranks (const Ranks&) = delete;
  Ranks&
  operator= (const Ranks&) = delete;
  ~Ranks();

  int
  rank () const
  {
    return rank_;
  }

  int
  size () const
  {
    return size_;
  }

  void
  meet () const;

  /** \brief Ends all with an exit code other than zero, at once; returns where there is
   * only this one. */
  void
  endAll (int exit_code) const;

private:
  struct State;

  std::unique_ptr<State> state_;
  int rank_ = 0, size_ = 1;
};

/** \brief Which parts of some work are a rank's, so that all have about as much to do;
 * the largest first. \param[in] parts how much work each is */
std::vector<std::size_t>
shareOf (std::size_t rank, std::size_t ranks, const std::vector<std::uint64_t>& parts);

} // namespace pcl_ops::apps
