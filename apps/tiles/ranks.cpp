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
  boost::mpi::environment environment{boost::mpi::threading::funneled, false};
  boost::mpi::communicator world;
};
#endif

Ranks::Ranks()
{
#ifdef PCL_OPS_WITH_MPI
  // MPI is slow to start: only processes of mpirun, which have one of these, do so.
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
  constexpr std::chrono::milliseconds nap (1);
  MPI_Request request;
  MPI_Ibarrier (state_->world, &request);
  int all_are_here = 0;
  while (MPI_Test (&request, &all_are_here, MPI_STATUS_IGNORE) == MPI_SUCCESS &&
         all_are_here == 0)
    std::this_thread::sleep_for (nap);
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
shareOf (std::size_t rank, std::size_t ranks, const std::vector<std::uint64_t>& parts)
{
  std::vector<std::size_t> order (parts.size());
  std::vector<std::size_t> own;
  std::iota (order.begin(), order.end(), std::size_t (0));
  std::stable_sort (order.begin(), order.end(), [&] (std::size_t a, std::size_t b) {
    return parts[a] > parts[b];
  });
  std::vector<std::uint64_t> load (ranks, 0);
  for (const std::size_t part : order) {
    const auto idlest = std::min_element (load.begin(), load.end());
    *idlest += parts[part];
    if (idlest == load.begin() + rank)
      own.push_back (part);
  }
  return own;
}

} // namespace pcl_ops::apps
