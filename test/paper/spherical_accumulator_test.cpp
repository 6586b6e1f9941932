// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "paper/spherical_accumulator.h"
#include "scene.h"

#include <set>
#include <tuple>

using namespace pcl_ops::internal;

namespace {

/** A bin of the accumulator. */
struct AccumulatorBin {
  std::uint32_t direction;
  int rho;

  bool
  operator<(const AccumulatorBin& other) const
  {
    return std::tie (direction, rho) < std::tie (other.direction, other.rho);
  }
  bool
  operator== (const AccumulatorBin& other) const
  {
    return std::tie (direction, rho) == std::tie (other.direction, other.rho);
  }
};

/** Bins of 15 degrees by 15 degrees by 5 cm, up to a rho of 2 m. */
const HoughSpace coarse_space{BallDirections (12), 40, 0.05};

/** Votes of these values for a bin and the next ones along rho. */
KernelVotes
votesFor (const AccumulatorBin& bin, std::vector<float> values)
{
  const int end = bin.rho + static_cast<int> (values.size());
  return {{{bin.direction, bin.rho, end, 0}}, std::move (values)};
}

/** Votes of a kernel with this mean [m], [rad], [rad]. The standard deviations are 0.1
 * m, 2 bins of rho, and 0.22 rad, nearly a bin of phi or theta. */
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

/** Votes of a bin. Bin -1 of rho is bin 0 of the opposite direction; bins beyond the
 * last one have 0 votes. */
float
votesOf (const SphericalAccumulator& accumulator, const AccumulatorBin& bin)
{
  if (bin.rho < 0)
    return accumulator
        .votes[coarse_space.directions.opposite (bin.direction)][-1 - bin.rho];
  return bin.rho < coarse_space.rho_num ? accumulator.votes[bin.direction][bin.rho]
                                        : 0.0f;
}

/** The votes of a bin and its six neighbors, with the weights of Limberger & Oliveira.
 */
float
smoothedVotesOf (const SphericalAccumulator& accumulator, const AccumulatorBin& bin)
{
  constexpr float own_weight = 0.2f, neighbor_weight = 0.1333f;
  float neighbors = votesOf (accumulator, {bin.direction, bin.rho - 1}) +
                    votesOf (accumulator, {bin.direction, bin.rho + 1});
  for (const std::uint32_t side : coarse_space.directions.beside (bin.direction))
    neighbors += votesOf (accumulator, {side, bin.rho});
  return own_weight * votesOf (accumulator, bin) + neighbor_weight * neighbors;
}

/** The peaks as Limberger & Oliveira find them: the bins with votes are visited from
 * the highest smoothed votes down, and the 3 x 3 x 3 bins around each are marked. A bin
 * is a peak if none of these was marked before. For votes away from the center, as it
 * does not mark bins beyond it. */
std::set<AccumulatorBin>
peaksByVisitingSortedBins (const SphericalAccumulator& accumulator)
{
  // Minus the smoothed votes, direction and bin of rho: sorted, the highest is first.
  std::vector<std::tuple<float, std::uint32_t, int>> bins;
  for (std::uint32_t direction = 0; direction < coarse_space.directions.size();
       ++direction)
    for (int rho = 0; rho < coarse_space.rho_num; ++rho)
      if (accumulator.votes[direction][rho] > 0.0f)
        bins.emplace_back (
            -smoothedVotesOf (accumulator, {direction, rho}), direction, rho);
  std::sort (bins.begin(), bins.end());
  std::set<AccumulatorBin> marked, peaks;
  for (const auto& [minus_votes, direction, rho] : bins) {
    bool is_any_marked = false;
    for (const std::uint32_t near : coarse_space.directions.around (direction))
      for (int near_rho = rho - 1; near_rho <= rho + 1; ++near_rho)
        is_any_marked |= !marked.insert ({near, near_rho}).second;
    if (!is_any_marked)
      peaks.insert ({direction, rho});
  }
  return peaks;
}

} // namespace

TEST (SphericalAccumulator, AddsVotesUp)
{
  SphericalAccumulator accumulator (coarse_space);
  constexpr std::uint32_t first_voter = 0, second_voter = 1;
  constexpr std::uint32_t direction = 5, other_direction = 6;
  accumulator.add (votesFor ({direction, 10}, {1.0f, 2.0f}), first_voter);
  accumulator.add (votesFor ({direction, 11}, {4.0f}), second_voter);
  EXPECT_EQ (accumulator.votes[direction][10], 1.0f);
  EXPECT_EQ (accumulator.votes[direction][11], 2.0f + 4.0f);
  EXPECT_EQ (accumulator.votes[other_direction][10], 0.0f);
}

TEST (SphericalAccumulator, HasOnePeakForAKernelNearTheCenterOrAPole)
{
  for (const auto& [rho, phi] :
       {std::pair (0.01, 1.3), {1.0, 0.0}, {1.0, 0.1}, {1.0, 3.1}}) {
    SphericalAccumulator accumulator (coarse_space);
    constexpr double theta = 1.0;
    constexpr std::uint32_t voter = 0;
    accumulator.add (votesOfKernelAt (rho, phi, theta), voter);
    EXPECT_EQ (accumulator.peaks().size(), 1u) << phi;
  }
}

TEST (SphericalAccumulator, HasThePeaksThatVisitingTheSortedBinsFinds)
{
  RandomGenerator generator (seedOfTest());
  const auto directions = static_cast<std::uint32_t> (coarse_space.directions.size());
  SphericalAccumulator accumulator (coarse_space);
  for (std::uint32_t voter = 0; voter < 2000; ++voter) {
    const auto vote = static_cast<float> (drawUnit (generator));
    const std::uint32_t direction = drawBelow (generator, directions);
    // Away from the center and from the last of the 40 bins.
    const int rho = 4 + static_cast<int> (drawBelow (generator, 34));
    accumulator.add (votesFor ({direction, rho}, {vote, vote}), voter);
  }
  const std::set<AccumulatorBin> expected = peaksByVisitingSortedBins (accumulator);
  EXPECT_GT (expected.size(), 20u);
  std::set<AccumulatorBin> found;
  for (const HoughPeak& peak : accumulator.peaks())
    found.insert ({peak.direction, peak.bin});
  EXPECT_TRUE (found == expected);
}

TEST (SphericalAccumulator, RemembersWhoVotedAroundAPeakAlsoAcrossTheCenter)
{
  // Voters 0 and 1 vote for adjacent bins. Voters 3 and 4 vote for bin 0 of opposite
  // directions; these bins touch at the center. Voter 2 votes for a bin that is next to
  // none of the others.
  SphericalAccumulator accumulator (coarse_space);
  const std::uint32_t beside = coarse_space.directions.beside (40)[3]; // to the east
  accumulator.add (votesFor ({40, 10}, {5.0f, 5.0f}), 0);
  accumulator.add (votesFor ({beside, 11}, {1.0f}), 1);
  accumulator.add (votesFor ({40, 14}, {1.0f}), 2);
  accumulator.add (votesFor ({80, 0}, {4.0f}), 3);
  accumulator.add (votesFor ({coarse_space.directions.opposite (80), 0}, {1.0f}), 4);
  std::vector<std::vector<std::uint32_t>> voters;
  for (const HoughPeak& peak : accumulator.peaks())
    voters.push_back (peak.voters);
  EXPECT_EQ (voters, (std::vector<std::vector<std::uint32_t>>{{0, 1}, {3, 4}, {2}}))
      << "the peaks by falling votes";
}
