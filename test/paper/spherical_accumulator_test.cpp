// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "paper/spherical_accumulator.h"
#include "scene.h"

#include <set>
#include <tuple>

using namespace pcl_ops::internal;

namespace {

using Bin = std::pair<std::uint32_t, int>;

const HoughSpace coarse_space{BallDirections (12), 40, 0.05};

KernelVotes
votesFor (const Bin& bin, std::vector<float> values)
{
  const int end = bin.second + static_cast<int> (values.size());
  return {{{bin.first, bin.second, end, 0}}, std::move (values)};
}

KernelVotes
votesOfKernelAt (double rho, double phi, double theta)
{
  PlaneKernel kernel;
  kernel.mean = Eigen::Vector3d (rho, phi, theta);
  kernel.covariance = Eigen::Vector3d (0.01, 0.05, 0.05).asDiagonal();
  KernelVotes votes;
  castVotes (kernel, coarse_space, votes);
  return votes;
}

/** Votes of a bin. Below bin 0 they are those of the opposite direction; beyond the
 * last bin there are 0 votes. */
float
votesOf (const SphericalAccumulator& accumulator, std::uint32_t direction, int bin)
{
  if (bin < 0)
    return accumulator.votes[coarse_space.directions.opposite (direction)][-1 - bin];
  return bin < coarse_space.rho_num ? accumulator.votes[direction][bin] : 0.0f;
}

float
smoothed (const SphericalAccumulator& accumulator, const Bin& bin)
{
  float neighbors = votesOf (accumulator, bin.first, bin.second - 1) +
                    votesOf (accumulator, bin.first, bin.second + 1);
  for (const std::uint32_t side : coarse_space.directions.beside (bin.first))
    neighbors += votesOf (accumulator, side, bin.second);
  return 0.2f * votesOf (accumulator, bin.first, bin.second) + 0.1333f * neighbors;
}

/** Sorts all bins and walks them, marking those around each, as the method was
 * published. Only for votes away from the center. */
std::set<Bin>
peaksByWalking (const SphericalAccumulator& accumulator)
{
  std::vector<std::tuple<float, std::uint32_t, int>> bins;
  for (std::uint32_t direction = 0; direction < coarse_space.directions.size();
       ++direction)
    for (int bin = 0; bin < coarse_space.rho_num; ++bin)
      if (accumulator.votes[direction][bin] > 0.0f)
        bins.emplace_back (-smoothed (accumulator, {direction, bin}), direction, bin);
  std::sort (bins.begin(), bins.end());
  std::set<Bin> marked, peaks;
  for (const auto& [height, direction, bin] : bins) {
    bool meets_marked = false;
    for (const std::uint32_t near : coarse_space.directions.around (direction))
      for (int beside = bin - 1; beside <= bin + 1; ++beside)
        meets_marked |= !marked.insert ({near, beside}).second;
    if (!meets_marked)
      peaks.insert ({direction, bin});
  }
  return peaks;
}

} // namespace

TEST (SphericalAccumulator, AddsVotesUp)
{
  SphericalAccumulator accumulator (coarse_space);
  accumulator.add (votesFor ({5, 10}, {1.0f, 2.0f}), 0);
  accumulator.add (votesFor ({5, 11}, {4.0f}), 1);
  EXPECT_EQ (accumulator.votes[5][10], 1.0f);
  EXPECT_EQ (accumulator.votes[5][11], 6.0f);
  EXPECT_EQ (accumulator.votes[6][10], 0.0f);
}

TEST (SphericalAccumulator, PeaksOnceForAKernelAcrossTheCenterOrAPole)
{
  for (const auto& [rho, phi] :
       {std::pair (0.01, 1.3), {1.0, 0.0}, {1.0, 0.1}, {1.0, 3.1}}) {
    SphericalAccumulator accumulator (coarse_space);
    accumulator.add (votesOfKernelAt (rho, phi, 1.0), 0);
    EXPECT_EQ (accumulator.peaks().size(), 1u) << phi;
  }
}

TEST (SphericalAccumulator, PeaksWhereAWalkOverSortedBinsDoes)
{
  RandomGenerator generator (seedOfTest());
  const auto directions = static_cast<std::uint32_t> (coarse_space.directions.size());
  SphericalAccumulator accumulator (coarse_space);
  for (std::uint32_t voter = 0; voter < 2000; ++voter) {
    const auto vote = static_cast<float> (drawUnit (generator));
    const std::uint32_t direction = drawBelow (generator, directions);
    const int bin = 4 + static_cast<int> (drawBelow (generator, 34));
    accumulator.add (votesFor ({direction, bin}, {vote, vote}), voter);
  }
  const std::set<Bin> expected = peaksByWalking (accumulator);
  EXPECT_GT (expected.size(), 20u);
  std::set<Bin> found;
  for (const HoughPeak& peak : accumulator.peaks())
    found.insert ({peak.direction, peak.bin});
  EXPECT_EQ (found, expected);
}

TEST (SphericalAccumulator, RemembersWhoVotedAroundAPeakAlsoAcrossTheCenter)
{
  SphericalAccumulator accumulator (coarse_space);
  const std::uint32_t beside = coarse_space.directions.beside (40)[3];
  accumulator.add (votesFor ({40, 10}, {5.0f, 5.0f}), 0);
  accumulator.add (votesFor ({beside, 11}, {1.0f}), 1);
  accumulator.add (votesFor ({40, 14}, {1.0f}), 2);
  accumulator.add (votesFor ({80, 0}, {4.0f}), 3);
  accumulator.add (votesFor ({coarse_space.directions.opposite (80), 0}, {1.0f}), 4);
  std::vector<std::vector<std::uint32_t>> voters;
  for (const HoughPeak& peak : accumulator.peaks())
    voters.push_back (peak.voters);
  EXPECT_EQ (voters, (std::vector<std::vector<std::uint32_t>>{{0, 1}, {3, 4}, {2}}))
      << "by falling height";
}
