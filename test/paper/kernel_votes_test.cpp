// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/LU>

#include "paper/kernel_votes.h"
#include "scene.h"

#include <map>
#include <tuple>

using namespace pcl_ops::internal;

namespace {

/** rho [m], phi and theta [rad] of the plane whose point nearest to the center of the
 * ball is p, relative to that center. */
Eigen::Vector3d
sphericalOf (const Eigen::Vector3d& p)
{
  return Eigen::Vector3d (
      p.norm(), std::acos (p.z() / p.norm()), std::atan2 (p.y(), p.x()));
}

/** The Jacobian of \ref sphericalOf by central differences. */
Eigen::Matrix3d
jacobianAt (const Eigen::Vector3d& p)
{
  constexpr double step = 1e-6; // [m]
  Eigen::Matrix3d jacobian;
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d shift = step * Eigen::Vector3d::Unit (axis);
    jacobian.col (axis) =
        (sphericalOf (p + shift) - sphericalOf (p - shift)) / (2.0 * step);
  }
  return jacobian;
}

/** Center of the ball. */
const Eigen::Vector3d center (1.0, 2.0, 3.0);
/** Normal and centroid of a plane that is neither through the center nor parallel to an
 * axis. */
const Eigen::Vector3d normal = Eigen::Vector3d (0.3, -0.5, 0.7).normalized();
const Eigen::Vector3d centroid = center + Eigen::Vector3d (1.0, 0.2, 0.9);

/** A covariance of points [m^2]: root times its transpose is positive definite. */
Eigen::Matrix3d
someCovariance ()
{
  Eigen::Matrix3d root;
  root << 0.1, 0.02, 0.0, 0.0, 0.2, 0.05, 0.03, 0.0, 0.15; // row by row
  return root * root.transpose();
}

constexpr double weight_of_plane = 0.5;

/** The kernel of points with \ref someCovariance, given the centroid and the normal of
 * their plane. */
PlaneKernel
kernelOfPoints (const Eigen::Vector3d& their_centroid,
                const Eigen::Vector3d& their_normal)
{
  const pcl_ops::PlaneFit fit{
      pcl_ops::planeThrough (their_centroid, their_normal), their_centroid, {}};
  return planeKernel (fit, someCovariance(), center, weight_of_plane);
}

constexpr double rho_step = 0.01; // [m]
/** Bins of 1 degree by 1 degree by 1 cm, up to a rho of 2 m. */
const HoughSpace space{BallDirections (180), 200, rho_step};
/** The bin whose lower end is a rho of 1 m. */
constexpr int bin_of_1_m = 100;

/** A bin of the accumulator. */
struct Bin {
  std::uint32_t direction;
  int rho;

  bool
  operator<(const Bin& other) const
  {
    return std::tie (direction, rho) < std::tie (other.direction, other.rho);
  }
  bool
  operator== (const Bin& other) const
  {
    return std::tie (direction, rho) == std::tie (other.direction, other.rho);
  }
};

/** The votes of each bin; fails if a bin gets votes above 0 more than once. */
std::map<Bin, double>
votesOf (const PlaneKernel& kernel)
{
  KernelVotes votes;
  castVotes (kernel, space, votes);
  std::map<Bin, double> bins;
  for (const VoteRay& ray : votes.rays)
    for (int rho = ray.begin; rho < ray.end; ++rho) {
      double& vote = bins[{ray.direction, rho}];
      const float added = votes.values[ray.first_value + (rho - ray.begin)];
      EXPECT_TRUE (vote == 0.0 || added == 0.0f) << "a kernel counts once per bin";
      vote += added;
    }
  return bins;
}

/** A kernel with this mean [m], [rad], [rad]. Its standard deviations are 3 bins of
 * rho, 3 of phi and, at the equator, 4 of theta; all three are correlated. */
PlaneKernel
kernelWithMean (double rho, double phi, double theta)
{
  const Eigen::Vector3d deviations (3_cm, 3_deg, 4_deg);
  Eigen::Matrix3d correlation;
  correlation << 1.0, 0.5, -0.3, 0.5, 1.0, 0.2, -0.3, 0.2, 1.0;
  PlaneKernel kernel;
  kernel.mean = Eigen::Vector3d (rho, phi, theta);
  kernel.covariance = deviations.asDiagonal() * correlation * deviations.asDiagonal();
  kernel.weight = 0.7;
  return kernel;
}

/** The density of a kernel times its weight, at rho, phi and theta. */
double
density (const PlaneKernel& kernel, const Eigen::Vector3d& rho_phi_theta)
{
  const Eigen::Vector3d offset = rho_phi_theta - kernel.mean;
  const double squared_mahalanobis_distance =
      offset.dot (kernel.covariance.inverse() * offset);
  const double squared_normalization =
      std::pow (2.0 * pi, 3) * kernel.covariance.determinant();
  return kernel.weight * std::exp (-0.5 * squared_mahalanobis_distance) /
         std::sqrt (squared_normalization);
}

/** The density two standard deviations from the mean, exp (-2^2 / 2) of that at the
 * mean: no vote is smaller. */
double
leastVote (const PlaneKernel& kernel)
{
  return std::exp (-2.0) * density (kernel, kernel.mean);
}

/** Largest density at the center of a bin over its equivalent coordinates: theta plus
 * or minus up to two turns, and phi reflected at either pole with theta half a turn on.
 */
double
largestDensity (const PlaneKernel& kernel, const Bin& bin)
{
  const double rho = space.rhoOf (bin.rho),
               phi = space.directions.phiOf (bin.direction);
  double largest = 0.0;
  for (int turn = -2; turn <= 2; ++turn) {
    const double theta = space.directions.thetaOf (bin.direction) + 2.0 * pi * turn;
    for (const Eigen::Vector3d& rho_phi_theta : {Eigen::Vector3d (rho, phi, theta),
                                                 {rho, -phi, theta + pi},
                                                 {rho, 2.0 * pi - phi, theta + pi}})
      largest = std::max (largest, density (kernel, rho_phi_theta));
  }
  return largest;
}

/** Whether a bin contains the mean of a kernel. */
bool
isBinOfMean (const PlaneKernel& kernel, const Bin& bin)
{
  const long row = std::lround (kernel.mean[1] / space.directions.phi_step);
  const std::uint32_t direction =
      space.directions.at (static_cast<int> (row), kernel.mean[2]);
  return bin == Bin{direction, static_cast<int> (kernel.mean[0] / space.rho_step)};
}

/** The integral of the votes over rho, phi and theta. */
double
massOf (const std::map<Bin, double>& votes)
{
  double mass = 0.0;
  for (const auto& [bin, vote] : votes) {
    const int row = space.directions.row_of[bin.direction];
    const double theta_step = 2.0 * pi / space.directions.patchesOfRow (row);
    mass += vote * space.rho_step * space.directions.phi_step * theta_step;
  }
  return mass;
}

// Probability of a trivariate Gaussian within two standard deviations.
constexpr double mass_within_two_deviations = 0.7385;

} // namespace

TEST (PlaneKernel, HasThePlaneAsMeanAndTheCovarianceOfThePointsPropagatedToIt)
{
  // The point of the plane that is nearest to the center, relative to the center.
  const Eigen::Vector3d p = (centroid - center).dot (normal) * normal;
  const Eigen::Matrix3d jacobian = jacobianAt (p);
  Eigen::Matrix3d expected = jacobian * someCovariance() * jacobian.transpose();
  expected (0, 0) += 1e-5; // as planeKernel adds to the variance of rho [m^2]
  for (const double sign : {1.0, -1.0}) {
    const PlaneKernel kernel = kernelOfPoints (centroid, sign * normal);
    EXPECT_LT ((kernel.mean - sphericalOf (p)).norm(), 1e-12);
    EXPECT_LT ((kernel.covariance - expected).norm(), 1e-6 * expected.norm());
    EXPECT_EQ (kernel.weight, weight_of_plane);
  }
}

TEST (PlaneKernel, IsFiniteAtThePolesAndThroughTheCenter)
{
  const Eigen::Vector3d north_pole = Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d south_pole = -Eigen::Vector3d::UnitZ();
  for (const Eigen::Vector3d& direction : {north_pole, south_pole, normal})
    for (const double rho : {1.0, 0.0}) {
      const PlaneKernel kernel = kernelOfPoints (center + rho * direction, direction);
      EXPECT_TRUE (kernel.mean.allFinite());
      EXPECT_GT (kernel.covariance.determinant(), 0.0);
    }
}

TEST (KernelVotes, AreTheDensityOfAllBinsWithinTwoDeviations)
{
  for (const double phi : {1.5, 0.02, 3.1}) { // near the equator and both poles
    constexpr double nearly_full_turn = 6.2;  // votes go on beyond it, from 0 on
    const PlaneKernel kernel = kernelWithMean (1.0, phi, nearly_full_turn);
    const std::map<Bin, double> votes = votesOf (kernel);
    const double least = leastVote (kernel);
    // All directions but the poles, where the azimuth is free.
    const auto south_pole = static_cast<std::uint32_t> (space.directions.size() - 1);
    // Up to five standard deviations of rho; every sixth bin, to save time.
    for (std::uint32_t direction = 1; direction < south_pole; ++direction)
      for (int rho = bin_of_1_m - 15; rho < bin_of_1_m + 15; rho += 6) {
        const Bin bin{direction, rho};
        const double expected = largestDensity (kernel, bin);
        // The bin of the mean gets the least vote if its center is farther away.
        // Rounding decides whether a bin on the border gets a vote.
        const bool is_on_border = std::abs (expected / least - 1.0) < 1e-4;
        if (isBinOfMean (kernel, bin) || is_on_border)
          continue;
        const auto found = votes.find (bin);
        const double vote = found == votes.end() ? 0.0 : found->second;
        ASSERT_NEAR (vote, expected > least ? expected : 0.0, 1e-4 * expected) << phi;
      }
  }
}

TEST (KernelVotes, ForAPoleAreTheDensityAtItsLikeliestAzimuth)
{
  const PlaneKernel kernel = kernelWithMean (1.0, 0.02, 6.2);
  // Brute force in steps of 1 mm and 1 mrad around the mean.
  Eigen::Vector3d likeliest (1.0, 0.0, 6.2); // rho, phi, theta
  for (int milliradians = -200; milliradians <= 200; ++milliradians)
    for (int millimeters = -20; millimeters <= 20; ++millimeters) {
      const Eigen::Vector3d other (
          1.0 + 0.001 * millimeters, 0.0, 6.2 + 0.001 * milliradians);
      if (density (kernel, other) > density (kernel, likeliest))
        likeliest = other;
    }
  const Bin at_pole{0, bin_of_1_m};
  const double expected =
      density (kernel, {space.rhoOf (at_pole.rho), 0.0, likeliest[2]});
  EXPECT_NEAR (votesOf (kernel).at (at_pole), expected, 1e-2 * expected);
}

TEST (KernelVotes, SumUpToTheMassWithinTwoDeviationsAlsoAcrossTheCenter)
{
  constexpr double phi = 1.5, theta = 2.0;
  // The opposite of the mean is at 94 degrees; this row is one standard deviation away.
  constexpr int row_beyond_center = 91;
  for (const double rho : {1.0, 0.015}) {
    const PlaneKernel kernel = kernelWithMean (rho, phi, theta);
    const std::map<Bin, double> votes = votesOf (kernel);
    EXPECT_NEAR (massOf (votes), kernel.weight * mass_within_two_deviations, 0.01);
    const Bin beyond_center{space.directions.at (row_beyond_center, theta + pi), 0};
    const bool reaches_center = rho < 0.06; // two standard deviations
    EXPECT_EQ (votes.count (beyond_center), reaches_center);
  }
}

TEST (KernelVotes, CountOncePerBinWhereTheyReachBeyondThePoleAndTheCenter)
{
  const PlaneKernel near_pole_and_center = kernelWithMean (0.01, 0.02, 1.0);
  PlaneKernel of_all_directions = near_pole_and_center;
  of_all_directions.covariance = Eigen::Vector3d (0.0001, 1e4, 1e4).asDiagonal();
  for (const PlaneKernel& kernel : {near_pole_and_center, of_all_directions})
    EXPECT_FALSE (votesOf (kernel).empty()) << "votesOf tests that each counts once";
}

TEST (KernelVotes, OfANarrowKernelBetweenBinCentersGoToTheBinOfItsMean)
{
  // The center of the bin is at a rho of 1.005 m and a phi of 69 degrees, or 1.2043.
  PlaneKernel kernel = kernelWithMean (1.0012, 1.2, 2.0);
  kernel.covariance *= 1e-6; // standard deviations of some thousandths of a bin
  const std::map<Bin, double> votes = votesOf (kernel);
  ASSERT_EQ (votes.size(), 1u);
  const Bin bin_of_mean{space.directions.at (69, 2.0), bin_of_1_m};
  EXPECT_TRUE (votes.begin()->first == bin_of_mean);
  EXPECT_NEAR (votes.begin()->second / leastVote (kernel), 1.0, 1e-5);
}

TEST (KernelVotes, StayNearTheMeanOfAKernelOfEndlessWidth)
{
  for (const double phi : {0.02, 1.2, 3.1}) {
    constexpr double theta = 2.0;
    PlaneKernel kernel = kernelWithMean (1.0, phi, theta);
    kernel.covariance = Eigen::Vector3d (1e4, 1e4, 1e4).asDiagonal();
    const std::map<Bin, double> votes = votesOf (kernel);
    EXPECT_GT (votes.size(), 100u);
    for (const auto& [bin, vote] : votes) {
      const Eigen::Vector3d direction = space.directions.vectorOf (bin.direction);
      const Eigen::AngleAxisd turn (theta, Eigen::Vector3d::UnitZ());
      const Eigen::Vector3d mean_direction =
          turn * Eigen::Vector3d (std::sin (phi), 0, std::cos (phi));
      // Votes end 8 rows and 8 patches, of 1 degree or somewhat more each, and 32 bins
      // of rho from the mean.
      ASSERT_LT (angleBetween (direction, mean_direction), 20_deg);
      ASSERT_NEAR (space.rhoOf (bin.rho), 1.0, 33 * rho_step);
    }
  }
}

TEST (KernelVotes, AreFiniteAndInTheBallBeyondTheLastRhoAndForAzimuthsManyTurnsAway)
{
  // The correlation of phi and theta is 0.999: in a row next to that of the mean the
  // likeliest azimuth is 1e12 rad away.
  PlaneKernel many_turns = kernelWithMean (1.0, 1.2, 2.0);
  many_turns.covariance = Eigen::Vector3d (1e-4, 1e-4, 1e24).asDiagonal();
  many_turns.covariance (1, 2) = many_turns.covariance (2, 1) = 0.999e10;
  const PlaneKernel at_last_rho = kernelWithMean (1.99, 1.5, 2.0); // bins end at 2 m
  for (const PlaneKernel& kernel : {many_turns, at_last_rho}) {
    const std::map<Bin, double> votes = votesOf (kernel);
    EXPECT_FALSE (votes.empty());
    for (const auto& [bin, vote] : votes) {
      EXPECT_LT (bin.direction, space.directions.size());
      EXPECT_LT (bin.rho, space.rho_num);
      EXPECT_TRUE (std::isfinite (vote));
    }
  }
}

TEST (KernelVotes, AreNoneForACovarianceOfZerosOrNan)
{
  PlaneKernel kernel = kernelWithMean (1.0, 1.2, 2.0);
  for (const double value : {0.0, double (NAN)}) {
    kernel.covariance.setConstant (value);
    EXPECT_TRUE (votesOf (kernel).empty());
  }
}
