// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ranks.h"

#ifdef PCL_OPS_WITH_MPI
#include <boost/mpi/communicator.hpp>
#include <boost/mpi/environment.hpp>

#include <chrono>
#include <cstdlib>
#include <thread>
#endif

#include <algorithm>
#include <numeric>

namespace pcl_ops::apps {

#ifdef PCL_OPS_WITH_MPI
struct Ranks::State {
  // main reports an exception first, then calls endAll.
  static constexpr bool exception_aborts_all = false;
  boost::mpi::environment environment{boost::mpi::threading::funneled,
                                      exception_aborts_all};
  boost::mpi::communicator world;
};
#endif

Ranks::Ranks()
{
#ifdef PCL_OPS_WITH_MPI
  // MPI is slow to start. Only processes that mpirun has started need it; they have one
  // of these variables.
  for (const char* variable : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_RANK"})
    if (!state_ && std::getenv (variable) != nullptr)
      state_ = std::make_shared<State>();
  if (!state_)
    return;
  rank = state_->world.rank();
  size = state_->world.size();
#endif
}

void
Ranks::meet() const
{
#ifdef PCL_OPS_WITH_MPI
  if (!state_)
    return;
  // A plain barrier would keep a processor busy while it waits.
  constexpr std::chrono::milliseconds pause (1);
  MPI_Request request;
  MPI_Ibarrier (state_->world, &request);
  int all_are_here = 0;
  while (MPI_Test (&request, &all_are_here, MPI_STATUS_IGNORE) == MPI_SUCCESS &&
         all_are_here == 0)
    std::this_thread::sleep_for (pause);
#endif
}

void
Ranks::endAll ([[maybe_unused]] int exit_code) const
{
#ifdef PCL_OPS_WITH_MPI
  if (size > 1)
    state_->world.abort (exit_code);
#endif
}

std::vector<std::size_t>
shareOf (std::size_t rank,
         std::size_t ranks,
         const std::vector<std::uint64_t>& work_of_part)
{
  std::vector<std::size_t> parts (work_of_part.size());
  std::iota (parts.begin(), parts.end(), std::size_t (0));
  const auto is_larger = [&] (std::size_t one, std::size_t other) {
    return work_of_part[one] > work_of_part[other];
  };
  std::stable_sort (parts.begin(), parts.end(), is_larger);
  // Each part goes to the rank with the least work so far.
  std::vector<std::uint64_t> work_of_rank (ranks, 0);
  std::vector<std::size_t> own_parts;
  for (const std::size_t part : parts) {
    const auto rank_with_least =
        std::min_element (work_of_rank.begin(), work_of_rank.end());
    *rank_with_least += work_of_part[part];
    if (rank_with_least == work_of_rank.begin() + rank)
      own_parts.push_back (part);
  }
  return own_parts;
}

} // namespace pcl_ops::apps
