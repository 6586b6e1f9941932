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

/** Votes for a bin and for the next ones along rho. */
KernelVotes
votesFor (const AccumulatorBin& bin, std::vector<float> values)
{
  const int end = bin.rho + static_cast<int> (values.size());
  return {{{bin.direction, bin.rho, end, 0}}, std::move (values)};
}

/** Votes of a kernel with this mean and with standard deviations of 2 bins of rho and
 * nearly a bin of each angle. */
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

/** The votes of a bin and its six neighbors, weighted as published. */
float
smoothed (const SphericalAccumulator& accumulator, const AccumulatorBin& bin)
{
  float neighbors = votesOf (accumulator, bin.direction, bin.rho - 1) +
                    votesOf (accumulator, bin.direction, bin.rho + 1);
  for (const std::uint32_t side : coarse_space.directions.beside (bin.direction))
    neighbors += votesOf (accumulator, side, bin.rho);
  return 0.2f * votesOf (accumulator, bin.direction, bin.rho) + 0.1333f * neighbors;
}

/** The peaks as the method was published: visits the bins by falling height and marks
 * all bins around each; a bin around which none was marked before is a peak. Only for
 * votes away from the center. */
std::set<AccumulatorBin>
peaksByWalking (const SphericalAccumulator& accumulator)
{
  // Minus the height, direction and bin of rho: the highest comes first.
  std::vector<std::tuple<float, std::uint32_t, int>> bins;
  for (std::uint32_t direction = 0; direction < coarse_space.directions.size();
       ++direction)
    for (int rho = 0; rho < coarse_space.rho_num; ++rho)
      if (accumulator.votes[direction][rho] > 0.0f)
        bins.emplace_back (-smoothed (accumulator, {direction, rho}), direction, rho);
  std::sort (bins.begin(), bins.end());
  std::set<AccumulatorBin> marked, peaks;
  for (const auto& [minus_height, direction, rho] : bins) {
    bool meets_marked = false;
    for (const std::uint32_t near : coarse_space.directions.around (direction))
      for (int beside = rho - 1; beside <= rho + 1; ++beside)
        meets_marked |= !marked.insert ({near, beside}).second;
    if (!meets_marked)
      peaks.insert ({direction, rho});
  }
  return peaks;
}

} // namespace

TEST (SphericalAccumulator, AddsVotesUp)
{
  SphericalAccumulator accumulator (coarse_space);
  constexpr std::uint32_t first_voter = 0, second_voter = 1;
  accumulator.add (votesFor ({5, 10}, {1.0f, 2.0f}), first_voter);
  accumulator.add (votesFor ({5, 11}, {4.0f}), second_voter);
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
    const int rho = 4 + static_cast<int> (drawBelow (generator, 34)); // off the center
    accumulator.add (votesFor ({direction, rho}, {vote, vote}), voter);
  }
  const std::set<AccumulatorBin> expected = peaksByWalking (accumulator);
  EXPECT_GT (expected.size(), 20u);
  std::set<AccumulatorBin> found;
  for (const HoughPeak& peak : accumulator.peaks())
    found.insert ({peak.direction, peak.bin});
  EXPECT_TRUE (found == expected);
}

TEST (SphericalAccumulator, RemembersWhoVotedAroundAPeakAlsoAcrossTheCenter)
{
  // Voters 0 and 1 vote for adjacent bins, 3 and 4 for one bin and the bin next to it
  // beyond the center, 2 for a bin away from all others.
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
