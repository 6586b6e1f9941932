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

/** \brief A number for each bin of an accumulator ball. The bins of a direction are
 * allocated when it is first written to, so that memory grows with the directions in
 * use. Two more bins can be read at either end: bins -1 and -2 hold bins 0 and 1 of the
 * opposite direction once \ref mirrorCenter has been called; all others beyond the ends
 * are 0. */
class BallColumns {
public:
  /** \param[in] rho_num number of bins of a direction, at least 2 */
  BallColumns (std::size_t directions, int rho_num)
  : columns_ (directions), no_votes_ (static_cast<std::size_t> (rho_num + 2 * margin))
  {}

  bool
  isEmpty (std::uint32_t direction) const
  {
    return columns_[direction].empty();
  }

  /** \brief The bins of a direction, bin 0 first; zeros if it was never written to. */
  const float*
  operator[] (std::uint32_t direction) const
  {
    return (isEmpty (direction) ? no_votes_ : columns_[direction]).data() + margin;
  }

  /** \brief The bins of a direction to write to, bin 0 first. */
  float*
  columnToWrite (std::uint32_t direction)
  {
    if (isEmpty (direction))
      columns_[direction] = no_votes_;
    return columns_[direction].data() + margin;
  }

  /** \brief Copies bins 0 and 1 of each direction to bins -1 and -2 of the opposite
   * direction, which they adjoin at the center. */
  void
  mirrorCenter (const BallDirections& directions)
  {
    for (std::uint32_t direction = 0; direction < columns_.size(); ++direction) {
      const float first = (*this)[direction][0];
      const float second = (*this)[direction][1];
      if (first == 0.0f && second == 0.0f)
        continue;
      float* const mirrored = columnToWrite (directions.opposite (direction));
      mirrored[-1] = first;
      mirrored[-2] = second;
    }
  }

private:
  /** \brief Number of bins beyond either end: \ref PeakTest reads two. */
  static constexpr int margin = 2;

  /** \brief For each direction its bins, from bin -margin on; empty if unused. */
  std::vector<std::vector<float>> columns_;
  std::vector<float> no_votes_;
};

/** \brief Tests whether a bin is a peak: the highest of all bins whose 3 x 3 x 3
 * neighborhood overlaps its own, also across the poles and the center.
 * Heights are the smoothed votes of the bins. */
class PeakTest {
public:
  /** \param[in] heights after \ref BallColumns::mirrorCenter; outlives the test, as
   * \p directions does */
  PeakTest (const BallColumns& heights, const BallDirections& directions)
  : heights_ (heights)
  , directions_ (directions)
  , around_ (directions.size())
  , centers_around_ (directions.size())
  {
    for (std::uint32_t direction = 0; direction < directions.size(); ++direction) {
      if (heights.isEmpty (direction))
        continue;
      around_[direction] = directions.around (direction);
      for (const std::uint32_t other : around_[direction])
        centers_around_[other].push_back (direction);
    }
  }

  /** \param[in] direction one in use */
  bool
  isPeak (std::uint32_t direction, int bin) const
  {
    if (!noneIsHigherIn (direction, direction, bin))
      return false;
    for (const std::uint32_t near : around_[direction])
      for (const std::uint32_t overlapping : centers_around_[near])
        if (!noneIsHigherIn (overlapping, direction, bin))
          return false;
    return true;
  }

private:
  /** \brief Whether no bin of the direction \p column that is at most two bins from \p
   * bin is higher than the bin \p bin of \p direction. */
  bool
  noneIsHigherIn (std::uint32_t column, std::uint32_t direction, int bin) const
  {
    const float height = heights_[direction][bin];
    const float* const heights = heights_[column];
    // Of equally high bins, the lower direction, then the lower bin counts as higher.
    const auto comesFirst = [&] (int other) {
      const bool is_mirrored = other < 0; // bin -1 is bin 0 of the opposite direction
      const std::uint32_t other_direction =
          is_mirrored ? directions_.opposite (column) : column;
      const int other_bin = is_mirrored ? -1 - other : other;
      return std::tie (other_direction, other_bin) < std::tie (direction, bin);
    };
    for (int other = bin - 2; other <= bin + 2; ++other)
      if (heights[other] > height || (heights[other] == height && comesFirst (other)))
        return false;
    return true;
  }

  const BallColumns& heights_;
  const BallDirections& directions_;
  /** \brief For each direction in use those of its 3 x 3 neighborhood. */
  std::vector<std::vector<std::uint32_t>> around_;
  /** \brief For each direction those in use that have it in their neighborhood. */
  std::vector<std::vector<std::uint32_t>> centers_around_;
};

/** \brief A peak of the accumulator. */
struct HoughPeak {
  std::uint32_t direction = 0;
  int bin = 0;
  /** \brief The smoothed votes of the bin. */
  float votes = 0.0f;
  /** \brief The voters for the 3 x 3 x 3 bins around it; ascending, each once. */
  std::vector<std::uint32_t> voters;
};

/** \brief An accumulator ball with the votes for planes and their voters (Limberger &
 * Oliveira 2015, sections 3.3 and 3.4). */
struct SphericalAccumulator {
  HoughSpace space;
  BallColumns votes{space.directions.size(), space.rho_num};

  explicit SphericalAccumulator (HoughSpace bins) : space (std::move (bins)) {}

  /** \brief Adds the votes of a kernel.
   * \param[in] voter number of the kernel in \ref HoughPeak::voters */
  void
  add (const KernelVotes& kernel, std::uint32_t voter)
  {
    for (const VoteRay& ray : kernel.rays) {
      float* const bins = votes.columnToWrite (ray.direction);
      const float* value = &kernel.values[ray.first_value];
      for (int bin = ray.begin; bin < ray.end; ++bin)
        bins[bin] += *value++;
      voters_[ray.direction].push_back ({voter, ray.begin, ray.end});
    }
  }

  /** \brief The peaks, highest first. Votes are smoothed: 0.2 times the bin's own plus
   * 0.1333 times those of each of its six neighbors; bins without votes stay 0. Then,
   * in principle, bins are visited from the highest down and the 3 x 3 x 3 bins around
   * each are marked; a bin is a peak if no bin around it was marked before. Such a bin
   * is the highest of all bins whose neighborhood overlaps its own: \ref PeakTest tests
   * this without sorting the bins. Of equally high bins, the lower direction, then the
   * lower bin counts as higher. */
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
  /** \brief Returns the votes smoothed as \ref peaks says. */
  BallColumns
  smoothedVotes () const
  {
    constexpr float own_weight = 0.2f;         // as published
    constexpr float neighbor_weight = 0.1333f; // as published
    const BallDirections& directions = space.directions;
    BallColumns smoothed (directions.size(), space.rho_num);
    for (std::uint32_t direction = 0; direction < directions.size(); ++direction) {
      if (votes.isEmpty (direction))
        continue;
      const auto [to_north, to_south, to_west, to_east] = directions.beside (direction);
      const float* own = votes[direction];
      const float* north = votes[to_north];
      const float* south = votes[to_south];
      const float* west = votes[to_west];
      const float* east = votes[to_east];
      float* const result = smoothed.columnToWrite (direction);
      for (int bin = 0; bin < space.rho_num; ++bin) {
        const float neighbors = own[bin - 1] + own[bin + 1] + north[bin] + south[bin] +
                                west[bin] + east[bin];
        const float sum = own_weight * own[bin] + neighbor_weight * neighbors;
        result[bin] = own[bin] > 0.0f ? sum : 0.0f;
      }
      // At the center bin 0 of the opposite direction is a neighbor of bin 0. The votes
      // are not mirrored: own[-1] is 0.
      if (own[0] > 0.0f)
        result[0] += neighbor_weight * votes[directions.opposite (direction)][0];
    }
    return smoothed;
  }

  /** \brief Returns the voters for the 3 x 3 x 3 bins around a bin; ascending, each
   * once.
   */
  std::vector<std::uint32_t>
  votersAround (std::uint32_t direction, int bin) const
  {
    std::vector<std::uint32_t> voters;
    const auto addVotersOf = [&] (std::uint32_t column, int first, int last) {
      for (const VoterRange& range : voters_[column])
        if (range.begin <= last && range.end > first)
          voters.push_back (range.voter);
    };
    for (const std::uint32_t near : space.directions.around (direction)) {
      addVotersOf (near, bin - 1, bin + 1);
      if (bin == 0)
        addVotersOf (space.directions.opposite (near), 0, 0);
    }
    std::sort (voters.begin(), voters.end());
    voters.erase (std::unique (voters.begin(), voters.end()), voters.end());
    return voters;
  }

  /** \brief A voter and its range of bins of one direction, [begin, end). */
  struct VoterRange {
    std::uint32_t voter;
    int begin, end;
  };
  /** \brief The voters for each direction. */
  std::vector<std::vector<VoterRange>> voters_{space.directions.size()};
};

} // namespace pcl_ops::internal
