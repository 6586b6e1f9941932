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
struct Ranks {
  Ranks();

  void
  meet () const;

  /** \brief Ends all at once, by an exit code but 0; returns where only one is. */
  void
  endAll (int exit_code) const;

  std::size_t rank = 0, size = 1;

private:
  struct State;
  std::shared_ptr<State> state_;
};

/** \brief Which parts of some work are a rank's, so that all have about as much to do;
 * the largest first.
 * \param[in] parts how much work each is */
std::vector<std::size_t>
shareOf (std::size_t rank, std::size_t ranks, const std::vector<std::uint64_t>& parts);

} // namespace pcl_ops::apps
