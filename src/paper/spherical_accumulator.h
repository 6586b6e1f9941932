// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "paper/ball_directions.h"
#include "paper/kernel_votes.h"

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <utility>
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
  mirrorCenter (const BallDirections& directions)
  {
    for (std::uint32_t direction = 0; direction < columns_.size(); ++direction) {
      const float first = (*this)[direction][0];
      const float second = (*this)[direction][1];
      if (first == 0.0f && second == 0.0f)
        continue;
      float* const mirrored = write (directions.opposite (direction));
      mirrored[-1] = first;
      mirrored[-2] = second;
    }
  }

private:
  static constexpr int margin = 2;

  std::vector<std::vector<float>> columns_;
  std::vector<float> no_votes_;
};

/** \brief Finds the bins that are the highest within two steps, between them the seams
 * of the ball. */
class PeakTest {
public:
  PeakTest (const BallColumns& heights, const BallDirections& directions)
  : heights_ (heights)
  , directions_ (directions)
  , around_ (directions.size())
  , centered_around_ (directions.size())
  {
    for (std::uint32_t direction = 0; direction < directions.size(); ++direction) {
      if (heights.isEmpty (direction))
        continue;
      around_[direction] = directions.around (direction);
      for (const std::uint32_t other : around_[direction])
        centered_around_[other].push_back (direction);
    }
  }

  bool
  isPeak (std::uint32_t direction, int bin) const
  {
    if (!isHighestOf (direction, direction, bin))
      return false;
    for (const std::uint32_t near : around_[direction])
      for (const std::uint32_t overlapping : centered_around_[near])
        if (!isHighestOf (overlapping, direction, bin))
          return false;
    return true;
  }

private:
  /** \brief No bin of a column within two of a bin's is higher than it. */
  bool
  isHighestOf (std::uint32_t column, std::uint32_t direction, int bin) const
  {
    const float height = heights_[direction][bin];
    const float* const heights = heights_[column];
    const auto comes_first = [&] (int other) {
      const auto real = other < 0
                            ? std::pair (directions_.opposite (column), -1 - other)
                            : std::pair (column, other);
      return real < std::pair (direction, bin);
    };
    for (int other = bin - 2; other <= bin + 2; ++other)
      if (heights[other] > height || (heights[other] == height && comes_first (other)))
        return false;
    return true;
  }

  const BallColumns& heights_;
  const BallDirections& directions_;
  std::vector<std::vector<std::uint32_t>> around_;
  std::vector<std::vector<std::uint32_t>> centered_around_;
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
struct SphericalAccumulator {
  HoughSpace space;
  BallColumns votes{space.directions.size(), space.rho_num};

  explicit SphericalAccumulator (HoughSpace of) : space (std::move (of)) {}

  /** \brief Adds the votes of a kernel, which peaks will know by its number. */
  void
  add (const KernelVotes& kernel, std::uint32_t voter)
  {
    for (const VoteRay& ray : kernel.rays) {
      float* const bins = votes.write (ray.direction);
      const float* value = &kernel.values[ray.first_value];
      for (int bin = ray.begin; bin < ray.end; ++bin)
        bins[bin] += *value++;
      voters_[ray.direction].push_back ({voter, ray.begin, ray.end});
    }
  }

  /** \brief The peaks, highest first. Votes are smoothed (0.2 of a bin's own and 0.1333
   * of each of its six neighbors'). Bins with votes are then walked from the highest
   * down and the 3 x 3 x 3 bins around each are marked; a bin is a peak if nothing
   * around it was marked before. That is so if it is the highest of all bins whose
   * surroundings meet its own, which is how it is found here, without sorting the bins.
   * Of equals the one with the lower direction and bin counts as higher. */
  std::vector<HoughPeak>
  peaks () const
  {
    BallColumns heights = smoothedVotes();
    heights.mirrorCenter (space.directions);
    const PeakTest test (heights, space.directions);
    std::vector<HoughPeak> found;
    for (std::uint32_t direction = 0; direction < space.directions.size();
         ++direction) {
      const float* const column = heights[direction];
      for (int bin = 0; bin < space.rho_num; ++bin)
        if (column[bin] > 0.0f && test.isPeak (direction, bin))
          found.push_back (
              {direction, bin, column[bin], votersAround (direction, bin)});
    }
    std::sort (found.begin(), found.end(), [] (const HoughPeak& a, const HoughPeak& b) {
      return std::make_tuple (-a.votes, a.direction, a.bin) <
             std::make_tuple (-b.votes, b.direction, b.bin);
    });
    return found;
  }

private:
  BallColumns
  smoothedVotes () const
  {
    constexpr float own_weight = 0.2f;
    constexpr float neighbor_weight = 0.1333f;
    const BallDirections& directions = space.directions;
    BallColumns smoothed (directions.size(), space.rho_num);
    for (std::uint32_t direction = 0; direction < directions.size(); ++direction) {
      if (votes.isEmpty (direction))
        continue;
      const auto beside = directions.beside (direction);
      const float* own = votes[direction];
      const float* north = votes[beside[0]];
      const float* south = votes[beside[1]];
      const float* west = votes[beside[2]];
      const float* east = votes[beside[3]];
      float* const result = smoothed.write (direction);
      for (int bin = 0; bin < space.rho_num; ++bin) {
        const float neighbors = own[bin - 1] + own[bin + 1] + north[bin] + south[bin] +
                                west[bin] + east[bin];
        const float sum = own_weight * own[bin] + neighbor_weight * neighbors;
        result[bin] = own[bin] > 0.0f ? sum : 0.0f;
      }
      if (own[0] > 0.0f)
        result[0] += neighbor_weight * votes[directions.opposite (direction)][0];
    }
    return smoothed;
  }

  std::vector<std::uint32_t>
  votersAround (std::uint32_t direction, int bin) const
  {
    std::vector<std::uint32_t> voters;
    const auto add_voters_of = [&] (std::uint32_t column, int first, int last) {
      for (const VoterRange& range : voters_[column])
        if (range.begin <= last && range.end > first)
          voters.push_back (range.voter);
    };
    for (const std::uint32_t near : space.directions.around (direction)) {
      add_voters_of (near, bin - 1, bin + 1);
      if (bin == 0)
        add_voters_of (space.directions.opposite (near), 0, 0);
    }
    std::sort (voters.begin(), voters.end());
    voters.erase (std::unique (voters.begin(), voters.end()), voters.end());
    return voters;
  }

  struct VoterRange {
    std::uint32_t voter;
    int begin, end;
  };
  /** \brief For each direction who voted for which bins. */
  std::vector<std::vector<VoterRange>> voters_{space.directions.size()};
};

} // namespace pcl_ops::internal
