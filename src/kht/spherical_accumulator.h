// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kht/ball_directions.h"
#include "kht/kernel_votes.h"

#include <cstdint>
#include <vector>

namespace pcl_ops::internal {

/** \brief A number for each bin of a ball. A direction gets its bins when it is first
 * written to, so that memory goes with the directions that occur. Two bins more at
 * either end may be read as well: those below 0 are the opposite direction's, once
 * \ref mirrorCenter has been called. */
class BallColumns {
public:
  BallColumns (std::size_t directions, int rho_num)
  : columns_ (directions), no_votes_ (static_cast<std::size_t> (rho_num + 2 * margin))
  {}

  bool
  isEmpty (std::uint32_t direction) const
  {
    return columns_[direction].empty();
  }

  /** \brief The bins of a direction, the first one at 0. */
  const float*
  operator[] (std::uint32_t direction) const
  {
    return (isEmpty (direction) ? no_votes_ : columns_[direction]).data() + margin;
  }

  /** \brief The same to write to. */
  float*
  write (std::uint32_t direction)
  {
    if (isEmpty (direction))
      columns_[direction] = no_votes_;
    return columns_[direction].data() + margin;
  }

  /** \brief Copies what lies next to the center to before the opposite direction's
   * first bin. */
  void
  mirrorCenter (const BallDirections& directions);

private:
  static constexpr int margin = 2;

  std::vector<std::vector<float>> columns_;
  std::vector<float> no_votes_;
};

/** \brief A bin of the accumulator that stands out. */
struct HoughPeak {
  std::uint32_t direction = 0;
  int bin = 0;
  /** \brief Its votes, smoothed. */
  float votes = 0.0f;
  /** \brief Who voted for it or the bins around it; ascending, each once. */
  std::vector<std::uint32_t> voters;
};

/** \brief Votes for planes in an accumulator ball, and who cast them (Limberger &
 * Oliveira 2015, sections 3.3 and 3.4). */
class SphericalAccumulator {
public:
  explicit SphericalAccumulator (HoughSpace space);

  const HoughSpace&
  space () const
  {
    return space_;
  }

  /** \brief Adds the votes of a kernel, which peaks will know by its number. */
  void
  add (const KernelVotes& votes, std::uint32_t voter);

  float
  votesOf (std::uint32_t direction, int bin) const
  {
    return votes_[direction][bin];
  }

  /** \brief The peaks, highest first. Votes are smoothed (0.2 of a bin's own and 0.1333
   * of each of its six neighbors'). Bins with votes are then walked from the highest
   * down and the 3 x 3 x 3 bins around each are marked; a bin is a peak if nothing
   * around it was marked before. That is so if it is the highest of all bins whose
   * surroundings meet its own, which is how it is found here, without sorting the bins.
   * Of equals the one with the lower direction and bin counts as higher. */
  std::vector<HoughPeak>
  peaks () const;

private:
  BallColumns
  smoothedVotes () const;
  std::vector<std::uint32_t>
  votersAround (std::uint32_t direction, int bin) const;

  HoughSpace space_;
  BallColumns votes_;
  struct VoterRange {
    std::uint32_t voter;
    int begin, end;
  };
  /** For each direction who voted for which bins. */
  std::vector<std::vector<VoterRange>> voters_;
};

} // namespace pcl_ops::internal
