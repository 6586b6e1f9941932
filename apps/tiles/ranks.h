// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace pcl_ops::apps {

/** \brief The MPI processes that share one run. Without mpirun, or in a build without
 * MPI, there is one process, of rank 0. */
struct Ranks {
  Ranks();

  void
  meet () const;

  /** \brief Aborts all ranks with an exit code; returns if there is only one rank. */
  void
  endAll (int exit_code) const;

  std::size_t rank = 0, size = 1;

private:
  struct State;
  std::shared_ptr<State> state_;
};

/** \return positions of the parts that a rank works on, the largest first; all ranks
 * have about the same amount of work
 * \param[in] parts amount of work of each part */
std::vector<std::size_t>
shareOf (std::size_t rank, std::size_t ranks, const std::vector<std::uint64_t>& parts);

} // namespace pcl_ops::apps
