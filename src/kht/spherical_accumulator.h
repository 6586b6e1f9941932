// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kht/ball_directions.h"
#include "kht/kernel_votes.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace pcl_ops::internal {

/** \brief A number for each bin of a ball. A direction gets its column of bins when it
 * is first written to, so that memory goes with the directions that occur. */
class BallColumns {
public:
  /** \brief Bins beyond either end of a column that may be read as well: those below 0
   * are the opposite column's, once \ref mirrorCenter has been called. */
  static constexpr int margin = 2;

  /** \brief The bins of a direction that may be other than 0, margins left out. */
  struct Range {
    int begin = 0, end = 0;
  };

  BallColumns (std::size_t directions, int rho_num);

  /** \brief The column of a direction, to write to the bins of a range in. */
  float*
  write (std::uint32_t direction, Range range);

  /** \brief Bins -margin .. rho_num + margin - 1 of a direction; zeros for one without
   * a column. */
  const float*
  read (std::uint32_t direction) const
  {
    const Column& column = columns_[direction];
    return (column.bins ? column.bins.get() : zeros_.data()) + margin;
  }

  Range
  rangeOf (std::uint32_t direction) const
  {
    return columns_[direction].range;
  }

  /** \brief The directions that have a column, in the order they got it. */
  const std::vector<std::uint32_t>&
  directions () const
  {
    return directions_;
  }

  /** \brief Copies what lies next to the center into the opposite column's margin. */
  void
  mirrorCenter (const BallDirections& directions);

private:
  struct Column {
    std::unique_ptr<float[]> bins;
    Range range;
  };

  std::vector<float> zeros_;
  std::vector<Column> columns_;
  std::vector<std::uint32_t> directions_;
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

  /** \brief Adds the votes of a kernel.
   * \param[in] votes its votes, as \ref castVotes gives them
   * \param[in] voter what peaks will call it */
  void
  add (const KernelVotes& votes, std::uint32_t voter);

  float
  votesOf (std::uint32_t direction, int bin) const
  {
    return votes_.read (direction)[bin];
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
  HoughSpace space_;
  BallColumns votes_;
  struct VoterRange {
    std::uint32_t voter;
    int begin, end;
  };
  /** For each direction who voted for which bins. */
  std::vector<std::vector<VoterRange>> voters_;

  BallColumns
  smoothedVotes () const;
  void
  addVoters (std::vector<HoughPeak>& peaks) const;
};

} // namespace pcl_ops::internal
