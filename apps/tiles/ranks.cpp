// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ranks.h"

#ifdef PCL_OPS_WITH_MPI
#include <boost/mpi/communicator.hpp>
#include <boost/mpi/environment.hpp>

#include <cstdlib>
#endif

namespace pcl_ops::apps {

#ifdef PCL_OPS_WITH_MPI

struct Ranks::State {
  boost::mpi::environment environment{boost::mpi::threading::funneled, false};
  boost::mpi::communicator world;
};

namespace {

/** \brief Whether this process is one of several; starting MPI takes its time. */
bool
isOneOfSeveral ()
{
  for (const char* variable : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_RANK"})
    if (std::getenv (variable) != nullptr)
      return true;
  return false;
}

} // namespace

Ranks::Ranks() : state_ (isOneOfSeveral() ? std::make_unique<State>() : nullptr) {}

int
Ranks::rank() const
{
  return state_ ? state_->world.rank() : 0;
}

int
Ranks::size() const
{
  return state_ ? state_->world.size() : 1;
}

void
Ranks::meet() const
{
  if (state_)
    state_->world.barrier();
}

void
Ranks::endAll (int exit_code) const
{
  if (state_ && state_->world.size() > 1)
    state_->world.abort (exit_code);
}

#else

struct Ranks::State {};

Ranks::Ranks() = default;

int
Ranks::rank() const
{
  return 0;
}

int
Ranks::size() const
{
  return 1;
}

void
Ranks::meet() const
{}

void
Ranks::endAll (int) const
{}

#endif

Ranks::~Ranks() = default;

} // namespace pcl_ops::apps
