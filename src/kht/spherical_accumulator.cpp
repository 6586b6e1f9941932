// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kht/spherical_accumulator.h"

#include <algorithm>
#include <utility>

namespace pcl_ops::internal {
namespace {

constexpr float own_weight = 0.2f;
constexpr float neighbor_weight = 0.1333f;

/** Whether bins are the highest within two steps, between them the seams of the ball.
 */
class PeakTest {
public:
  PeakTest (const BallColumns& heights, const BallDirections& directions)
  : heights_ (heights)
  , directions_ (directions)
  , around_ (directions.size())
  , centered_around_ (directions.size())
  {
    for (const std::uint32_t direction : heights.directions()) {
      around_[direction] = directions.around (direction);
      for (const std::uint32_t other : around_[direction])
        centered_around_[other].push_back (direction);
    }
  }

  bool
  isPeak (std::uint32_t direction, int bin) const
  {
    const Bin candidate{direction, bin, heights_.read (direction)[bin]};
    if (!isHighestOf (direction, candidate))
      return false;
    for (const std::uint32_t near : around_[direction])
      if (!isHighestOf (near, candidate))
        return false;
    for (const std::uint32_t near : around_[direction])
      for (const std::uint32_t overlapping : centered_around_[near])
        if (!isHighestOf (overlapping, candidate))
          return false;
    return true;
  }

private:
  struct Bin {
    std::uint32_t direction;
    int bin;
    float height;
  };

  /** No bin of a direction within two of the candidate's is higher than it. */
  bool
  isHighestOf (std::uint32_t direction, const Bin& candidate) const
  {
    const float* heights = heights_.read (direction);
    for (int bin = candidate.bin - 2; bin <= candidate.bin + 2; ++bin)
      if (heights[bin] > candidate.height ||
          (heights[bin] == candidate.height && isBefore (direction, bin, candidate)))
        return false;
    return true;
  }

  bool
  isBefore (std::uint32_t direction, int bin, const Bin& candidate) const
  {
    const std::uint32_t real = bin < 0 ? directions_.opposite (direction) : direction;
    const int real_bin = bin < 0 ? -1 - bin : bin;
    return std::make_pair (real, real_bin) <
           std::make_pair (candidate.direction, candidate.bin);
  }

  const BallColumns& heights_;
  const BallDirections& directions_;
  std::vector<std::vector<std::uint32_t>> around_;
  std::vector<std::vector<std::uint32_t>> centered_around_;
};

} // namespace

BallColumns::BallColumns (std::size_t directions, int rho_num)
: zeros_ (static_cast<std::size_t> (rho_num + 2 * margin), 0.0f), columns_ (directions)
{}

float*
BallColumns::write (std::uint32_t direction, Range range)
{
  Column& column = columns_[direction];
  if (!column.bins) {
    column.bins = std::make_unique<float[]> (zeros_.size());
    column.range = range;
    directions_.push_back (direction);
  }
  column.range.begin = std::min (column.range.begin, range.begin);
  column.range.end = std::max (column.range.end, range.end);
  return column.bins.get() + margin;
}

void
BallColumns::mirrorCenter (const BallDirections& directions)
{
  const std::vector<std::uint32_t> with_column = directions_;
  for (const std::uint32_t direction : with_column) {
    const float first = read (direction)[0], second = read (direction)[1];
    if (first == 0.0f && second == 0.0f)
      continue;
    float* mirrored = write (directions.opposite (direction), {0, 0});
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
    float* bins = votes_.write (ray.direction, {ray.first_bin, end}) + ray.first_bin;
    const float* values = votes.values.data() + ray.first_value;
    for (std::uint32_t i = 0; i < ray.length; ++i)
      bins[i] += values[i];
    voters_[ray.direction].push_back ({voter, ray.first_bin, end});
  }
}

BallColumns
SphericalAccumulator::smoothedVotes() const
{
  BallColumns smoothed (space_.directions.size(), space_.rho_num);
  for (const std::uint32_t direction : votes_.directions()) {
    const auto beside = space_.directions.beside (direction);
    const float* own = votes_.read (direction);
    const float* north = votes_.read (beside[0]);
    const float* south = votes_.read (beside[1]);
    const float* west = votes_.read (beside[2]);
    const float* east = votes_.read (beside[3]);
    const BallColumns::Range range = votes_.rangeOf (direction);
    float* result = smoothed.write (direction, range);
    for (int bin = range.begin; bin < range.end; ++bin) {
      const float neighbors =
          own[bin - 1] + own[bin + 1] + north[bin] + south[bin] + west[bin] + east[bin];
      const float sum = own_weight * own[bin] + neighbor_weight * neighbors;
      result[bin] = own[bin] > 0.0f ? sum : 0.0f;
    }
    if (own[0] > 0.0f)
      result[0] +=
          neighbor_weight * votes_.read (space_.directions.opposite (direction))[0];
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
  for (const std::uint32_t direction : votes_.directions()) {
    const BallColumns::Range range = heights.rangeOf (direction);
    for (int bin = range.begin; bin < range.end; ++bin)
      if (const float height = heights.read (direction)[bin];
          height > 0.0f && test.isPeak (direction, bin))
        peaks.push_back ({direction, bin, height, {}});
  }
  std::sort (peaks.begin(), peaks.end(), [] (const HoughPeak& a, const HoughPeak& b) {
    return a.votes != b.votes ? a.votes > b.votes
                              : std::make_pair (a.direction, a.bin) <
                                    std::make_pair (b.direction, b.bin);
  });
  addVoters (peaks);
  return peaks;
}

void
SphericalAccumulator::addVoters (std::vector<HoughPeak>& peaks) const
{
  for (HoughPeak& peak : peaks) {
    const auto add_voters_of = [&] (std::uint32_t direction, int first, int last) {
      for (const VoterRange& range : voters_[direction])
        if (range.begin <= last && range.end > first)
          peak.voters.push_back (range.voter);
    };
    for (const std::uint32_t near : space_.directions.around (peak.direction)) {
      add_voters_of (near, peak.bin - 1, peak.bin + 1);
      if (peak.bin == 0)
        add_voters_of (space_.directions.opposite (near), 0, 0);
    }
    std::sort (peak.voters.begin(), peak.voters.end());
    peak.voters.erase (std::unique (peak.voters.begin(), peak.voters.end()),
                       peak.voters.end());
  }
}

} // namespace pcl_ops::internal
