// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kht/spherical_accumulator.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace pcl_ops::internal {
namespace {

/** Finds the bins that are the highest within two steps, between them the seams of the
 * ball. */
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
  /** No bin of a column within two of a bin's is higher than it. */
  bool
  isHighestOf (std::uint32_t column, std::uint32_t direction, int bin) const
  {
    const float height = heights_[direction][bin];
    const float* const heights = heights_[column];
    for (int other = bin - 2; other <= bin + 2; ++other)
      if (heights[other] > height ||
          (heights[other] == height && isBefore (column, other, direction, bin)))
        return false;
    return true;
  }

  bool
  isBefore (std::uint32_t column, int other, std::uint32_t direction, int bin) const
  {
    const auto real = other < 0 ? std::pair (directions_.opposite (column), -1 - other)
                                : std::pair (column, other);
    return real < std::pair (direction, bin);
  }

  const BallColumns& heights_;
  const BallDirections& directions_;
  std::vector<std::vector<std::uint32_t>> around_;
  std::vector<std::vector<std::uint32_t>> centered_around_;
};

} // namespace

void
BallColumns::mirrorCenter (const BallDirections& directions)
{
  for (std::uint32_t direction = 0; direction < columns_.size(); ++direction) {
    const float first = (*this)[direction][0], second = (*this)[direction][1];
    if (first == 0.0f && second == 0.0f)
      continue;
    float* const mirrored = write (directions.opposite (direction));
    mirrored[-1] = first;
    mirrored[-2] = second;
  }
}

SphericalAccumulator::SphericalAccumulator (HoughSpace space)
: space_ (std::move (space))
, votes_ (space_.directions.size(), space_.rho_num)
, voters_ (space_.directions.size())
{}

void
SphericalAccumulator::add (const KernelVotes& votes, std::uint32_t voter)
{
  for (const VoteRay& ray : votes.rays) {
    const int end = ray.first_bin + static_cast<int> (ray.length);
    float* const bins = votes_.write (ray.direction) + ray.first_bin;
    for (std::uint32_t i = 0; i < ray.length; ++i)
      bins[i] += votes.values[ray.first_value + i];
    voters_[ray.direction].push_back ({voter, ray.first_bin, end});
  }
}

BallColumns
SphericalAccumulator::smoothedVotes() const
{
  constexpr float own_weight = 0.2f, neighbor_weight = 0.1333f;
  const BallDirections& directions = space_.directions;
  BallColumns smoothed (directions.size(), space_.rho_num);
  for (std::uint32_t direction = 0; direction < directions.size(); ++direction) {
    if (votes_.isEmpty (direction))
      continue;
    const auto beside = directions.beside (direction);
    const float *own = votes_[direction], *north = votes_[beside[0]],
                *south = votes_[beside[1]], *west = votes_[beside[2]],
                *east = votes_[beside[3]];
    float* const result = smoothed.write (direction);
    for (int bin = 0; bin < space_.rho_num; ++bin) {
      const float neighbors =
          own[bin - 1] + own[bin + 1] + north[bin] + south[bin] + west[bin] + east[bin];
      const float sum = own_weight * own[bin] + neighbor_weight * neighbors;
      result[bin] = own[bin] > 0.0f ? sum : 0.0f;
    }
    if (own[0] > 0.0f)
      result[0] += neighbor_weight * votes_[directions.opposite (direction)][0];
  }
  return smoothed;
}

std::vector<HoughPeak>
SphericalAccumulator::peaks() const
{
  BallColumns heights = smoothedVotes();
  heights.mirrorCenter (space_.directions);
  const PeakTest test (heights, space_.directions);
  std::vector<HoughPeak> peaks;
  for (std::uint32_t direction = 0; direction < space_.directions.size(); ++direction) {
    const float* const column = heights[direction];
    for (int bin = 0; bin < space_.rho_num; ++bin)
      if (column[bin] > 0.0f && test.isPeak (direction, bin))
        peaks.push_back ({direction, bin, column[bin], votersAround (direction, bin)});
  }
  std::sort (peaks.begin(), peaks.end(), [] (const HoughPeak& a, const HoughPeak& b) {
    return std::make_tuple (-a.votes, a.direction, a.bin) <
           std::make_tuple (-b.votes, b.direction, b.bin);
  });
  return peaks;
}

std::vector<std::uint32_t>
SphericalAccumulator::votersAround (std::uint32_t direction, int bin) const
{
  std::vector<std::uint32_t> voters;
  const auto add_voters_of = [&] (std::uint32_t column, int first, int last) {
    for (const VoterRange& range : voters_[column])
      if (range.begin <= last && range.end > first)
        voters.push_back (range.voter);
  };
  for (const std::uint32_t near : space_.directions.around (direction)) {
    add_voters_of (near, bin - 1, bin + 1);
    if (bin == 0)
      add_voters_of (space_.directions.opposite (near), 0, 0);
  }
  std::sort (voters.begin(), voters.end());
  voters.erase (std::unique (voters.begin(), voters.end()), voters.end());
  return voters;
}

} // namespace pcl_ops::internal
