// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace pcl_ops::apps {

/** \brief The MPI processes, called ranks, that share one run. Without mpirun, or in a
 * build without MPI, there is one process, of rank 0. */
struct Ranks {
  Ranks();

  /** \brief Waits until all ranks have called this function. */
  void
  meet () const;

  /** \brief Aborts all ranks with an exit code; does nothing if there is only one rank.
   */
  void
  endAll (int exit_code) const;

  /** \brief Number of this process, from 0 on. */
  std::size_t rank = 0;
  /** \brief Number of all processes. */
  std::size_t size = 1;

private:
  struct State;
  std::shared_ptr<State> state_;
};

/** \brief Returns the positions of the parts (tiles or inputs) that a rank works on,
 * the largest part first. All ranks have about the same amount of work.
 * \param[in] ranks number of all ranks
 * \param[in] work_of_part amount of work of each part */
std::vector<std::size_t>
shareOf (std::size_t rank,
         std::size_t ranks,
         const std::vector<std::uint64_t>& work_of_part);

} // namespace pcl_ops::apps
