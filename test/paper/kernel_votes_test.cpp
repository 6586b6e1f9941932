// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/LU>

#include "paper/kernel_votes.h"
#include "scene.h"

#include <map>
#include <tuple>

using namespace pcl_ops::internal;

namespace {

/** rho, phi and theta of the plane whose point nearest to the center is p. */
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
  constexpr double step = 1e-6;
  Eigen::Matrix3d jacobian;
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d moved = step * Eigen::Vector3d::Unit (axis);
    jacobian.col (axis) =
        (sphericalOf (p + moved) - sphericalOf (p - moved)) / (2.0 * step);
  }
  return jacobian;
}

// Center of the ball, and a plane by its normal and its centroid.
const Eigen::Vector3d center (1.0, 2.0, 3.0);
const Eigen::Vector3d normal = Eigen::Vector3d (0.3, -0.5, 0.7).normalized();
const Eigen::Vector3d centroid = center + Eigen::Vector3d (1.0, 0.2, 0.9);

Eigen::Matrix3d
someCovariance ()
{
  Eigen::Matrix3d root;
  root << 0.1, 0.02, 0.0, 0.0, 0.2, 0.05, 0.03, 0.0, 0.15;
  return root * root.transpose();
}

constexpr double weight_of_plane = 0.5;

/** The kernel of points around a centroid on the plane with that normal. */
PlaneKernel
kernelOf (const Eigen::Vector3d& point, const Eigen::Vector3d& with_normal)
{
  const pcl_ops::PlaneFit fit{pcl_ops::planeThrough (point, with_normal), point, {}};
  return planeKernel (fit, someCovariance(), center, weight_of_plane);
}

constexpr double rho_step = 0.01; // [m]
/** Bins of 1 degree by 1 degree by 1 cm, up to a rho of 2 m. */
const HoughSpace space{BallDirections (180), 200, rho_step};

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

/** The votes of each bin; fails if a bin gets votes twice. */
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
      EXPECT_TRUE (vote == 0.0 || added == 0.0f) << "a kernel counts once";
      vote += added;
    }
  return bins;
}

/** A kernel with standard deviations of 3 bins of rho and phi and 4 of theta, all
 * correlated. */
PlaneKernel
kernelAt (double rho, double phi, double theta)
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

/** The weighted Gaussian of a kernel at (rho, phi, theta). */
double
density (const PlaneKernel& kernel, const Eigen::Vector3d& at)
{
  const Eigen::Vector3d offset = at - kernel.mean;
  const double squared_distance = offset.dot (kernel.covariance.inverse() * offset);
  const double squared_volume =
      std::pow (2.0 * pi, 3) * kernel.covariance.determinant();
  return kernel.weight * std::exp (-0.5 * squared_distance) /
         std::sqrt (squared_volume);
}

/** The density two standard deviations from the mean: no vote is smaller. */
double
leastVote (const PlaneKernel& kernel)
{
  return std::exp (-2.0) * density (kernel, kernel.mean);
}

/** Largest density at the equivalent coordinates of a bin: theta up to two turns on or
 * back, phi on either side of both poles. */
double
largestDensity (const PlaneKernel& kernel, const Bin& bin)
{
  const double rho = space.rhoOf (bin.rho),
               phi = space.directions.phiOf (bin.direction);
  double largest = 0.0;
  for (int turn = -2; turn <= 2; ++turn) {
    const double theta = space.directions.thetaOf (bin.direction) + 2.0 * pi * turn;
    for (const Eigen::Vector3d& at : {Eigen::Vector3d (rho, phi, theta),
                                      {rho, -phi, theta + pi},
                                      {rho, 2.0 * pi - phi, theta + pi}})
      largest = std::max (largest, density (kernel, at));
  }
  return largest;
}

/** Whether a bin contains the mean of a kernel. */
bool
isOwnBin (const PlaneKernel& kernel, const Bin& bin)
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

TEST (PlaneKernel, IsThePlaneSeenFromTheCenterWithThePointsCovarianceCarriedOver)
{
  const Eigen::Vector3d p = (centroid - center).dot (normal) * normal;
  const Eigen::Matrix3d jacobian = jacobianAt (p);
  Eigen::Matrix3d expected = jacobian * someCovariance() * jacobian.transpose();
  expected (0, 0) += 1e-5; // as planeKernel adds to the variance of rho [m^2]
  for (const double sign : {1.0, -1.0}) {
    const PlaneKernel kernel = kernelOf (centroid, sign * normal);
    EXPECT_LT ((kernel.mean - sphericalOf (p)).norm(), 1e-12);
    EXPECT_LT ((kernel.covariance - expected).norm(), 1e-6 * expected.norm());
    EXPECT_EQ (kernel.weight, weight_of_plane);
  }
}

TEST (PlaneKernel, IsFiniteAtThePolesAndThroughTheCenter)
{
  for (const Eigen::Vector3d& direction : {Eigen::Vector3d::UnitZ().eval(),
                                           Eigen::Vector3d (-Eigen::Vector3d::UnitZ()),
                                           normal})
    for (const double rho : {1.0, 0.0}) {
      const PlaneKernel kernel = kernelOf (center + rho * direction, direction);
      EXPECT_TRUE (kernel.mean.allFinite());
      EXPECT_GT (kernel.covariance.determinant(), 0.0);
    }
}

TEST (KernelVotes, AreTheDensityOfAllBinsWithinTwoDeviations)
{
  for (const double phi : {1.5, 0.02, 3.1}) { // at the equator and both poles
    const PlaneKernel kernel = kernelAt (1.0, phi, 6.2);
    const std::map<Bin, double> votes = votesOf (kernel);
    const double least = leastVote (kernel);
    const auto south_pole = static_cast<std::uint32_t> (space.directions.size() - 1);
    for (std::uint32_t direction = 1; direction < south_pole; ++direction)
      for (int rho = 85; rho < 115; rho += 6) { // around rho = 1 m, bin 100
        const Bin bin{direction, rho};
        const double expected = largestDensity (kernel, bin);
        const bool is_at_border = std::abs (expected / least - 1.0) < 1e-4;
        if (isOwnBin (kernel, bin) || is_at_border)
          continue;
        const auto found = votes.find (bin);
        const double vote = found == votes.end() ? 0.0 : found->second;
        ASSERT_NEAR (vote, expected > least ? expected : 0.0, 1e-4 * expected) << phi;
      }
  }
}

TEST (KernelVotes, MeetAPoleAtItsLikeliestAzimuth)
{
  const PlaneKernel kernel = kernelAt (1.0, 0.02, 6.2);
  Eigen::Vector3d likeliest (1.0, 0.0, 6.2);
  for (int theta_step = -200; theta_step <= 200; ++theta_step)
    for (int rho_millimeters = -20; rho_millimeters <= 20; ++rho_millimeters) {
      const Eigen::Vector3d other (
          1.0 + 0.001 * rho_millimeters, 0.0, 6.2 + 0.001 * theta_step);
      if (density (kernel, other) > density (kernel, likeliest))
        likeliest = other;
    }
  const Bin at_pole{0, 100};
  const double expected =
      density (kernel, {space.rhoOf (at_pole.rho), 0.0, likeliest[2]});
  EXPECT_NEAR (votesOf (kernel).at (at_pole), expected, 1e-2 * expected);
}

TEST (KernelVotes, SumUpToTheMassWithinTwoDeviationsAlsoAcrossTheCenter)
{
  for (const double rho : {1.0, 0.015}) {
    const PlaneKernel kernel = kernelAt (rho, 1.5, 2.0);
    const std::map<Bin, double> votes = votesOf (kernel);
    EXPECT_NEAR (massOf (votes), kernel.weight * mass_within_two_deviations, 0.01);
    const Bin beyond_center{space.directions.at (91, 2.0 + pi), 0};
    EXPECT_EQ (votes.count (beyond_center), rho < 1.0);
  }
}

TEST (KernelVotes, CountOncePerBinAlsoAcrossThePoleAndTheCenter)
{
  PlaneKernel endless = kernelAt (0.01, 0.02, 1.0);
  endless.covariance = Eigen::Vector3d (0.0001, 1e4, 1e4).asDiagonal();
  for (const PlaneKernel& kernel : {kernelAt (0.01, 0.02, 1.0), endless})
    EXPECT_FALSE (votesOf (kernel).empty());
}

TEST (KernelVotes, OfAKernelBetweenBinCentersGoToItsOwnBin)
{
  PlaneKernel kernel = kernelAt (1.0012, 1.2, 2.0);
  kernel.covariance *= 1e-6;
  const std::map<Bin, double> votes = votesOf (kernel);
  ASSERT_EQ (votes.size(), 1u);
  const Bin own{space.directions.at (69, 2.0), 100};
  EXPECT_TRUE (votes.begin()->first == own);
  EXPECT_NEAR (votes.begin()->second / leastVote (kernel), 1.0, 1e-5);
}

TEST (KernelVotes, StayAroundTheKernelForAnEndlessSpread)
{
  for (const double phi : {0.02, 1.2, 3.1}) {
    constexpr double theta = 2.0;
    PlaneKernel kernel = kernelAt (1.0, phi, theta);
    kernel.covariance = Eigen::Vector3d (1e4, 1e4, 1e4).asDiagonal();
    const std::map<Bin, double> votes = votesOf (kernel);
    EXPECT_GT (votes.size(), 100u);
    for (const auto& [bin, vote] : votes) {
      const Eigen::Vector3d direction = space.directions.vectorOf (bin.direction);
      const Eigen::AngleAxisd turn (theta, Eigen::Vector3d::UnitZ());
      const Eigen::Vector3d normal_of_kernel =
          turn * Eigen::Vector3d (std::sin (phi), 0, std::cos (phi));
      // Votes end 8 directions and 32 bins of rho from the middle.
      ASSERT_LT (angleBetween (direction, normal_of_kernel), 20_deg);
      ASSERT_NEAR (space.rhoOf (bin.rho), 1.0, 33 * rho_step);
    }
  }
}

TEST (KernelVotes, EndAtTheLastRhoAndWhereTheLikeliestAzimuthIsManyTurnsAway)
{
  PlaneKernel many_turns = kernelAt (1.0, 1.2, 2.0);
  many_turns.covariance = Eigen::Vector3d (1e-4, 1e-4, 1e24).asDiagonal();
  many_turns.covariance (1, 2) = many_turns.covariance (2, 1) = 0.999e10;
  const PlaneKernel at_last_rho = kernelAt (1.99, 1.5, 2.0);
  for (const PlaneKernel& kernel : {many_turns, at_last_rho})
    for (const auto& [bin, vote] : votesOf (kernel)) {
      EXPECT_LT (bin.direction, space.directions.size());
      EXPECT_LT (bin.rho, space.rho_num);
      EXPECT_TRUE (std::isfinite (vote));
    }
}

TEST (KernelVotes, AreNoneWithoutACovariance)
{
  PlaneKernel kernel = kernelAt (1.0, 1.2, 2.0);
  for (const double none : {0.0, double (NAN)}) {
    kernel.covariance.setConstant (none);
    EXPECT_TRUE (votesOf (kernel).empty());
  }
}
