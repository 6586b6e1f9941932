// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "paper/kernel_votes.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace pcl_ops::internal {
namespace {

// Largest squared Mahalanobis distance of a vote from the mean of the kernel: votes end
// at two standard deviations, as published.
constexpr double max_squared_deviation = 4.0;

// Votes go no farther than this from the row of the mean [rows], from the likeliest
// azimuth of a row [patches] and from the likeliest rho of a direction [bins]. In
// clouds with hardly any noise, kernels of a plane through the center reach all
// directions, and votes for all directions are of no use. With these limits, chosen by
// hand, slightly more planes are found, too.
constexpr double max_directions = 8.0;
constexpr double max_bins = 32.0;

// Largest number of a patch in a row, counted on over several turns: if the azimuth of
// a kernel is hardly determined, the likeliest azimuth in another row may be many turns
// away.
constexpr int max_patches = 1 << 30;

// Lower bound, in planeKernel, of px^2 + py^2 and of rho^2 [m^2], where p = rho normal:
// so the Jacobian stays finite at the poles and for planes through the center. The
// bound is that of the published program.
constexpr double min_squared_radius = 1e-5;

// Added to the variance of rho [m^2], as published, so that kernels of exact planes
// have a width.
constexpr double min_rho_variance = 1e-5;

/** Converts to int, clamped to low .. high, so that no double overflows. */
int
clampedToInt (double value, int low, int high)
{
  return static_cast<int> (std::clamp<double> (value, low, high));
}

/** A direction's offset from the mean of a kernel [rad]. */
struct Offset {
  double phi = 0.0;
  double theta = 0.0;
};

/** A kernel's density, split into that of (phi, theta) and that of rho given both. */
class KernelDensity {
public:
  explicit KernelDensity (const PlaneKernel& kernel)
  {
    const Eigen::Matrix3d& sigma = kernel.covariance;
    mean_rho = kernel.mean[0];
    mean_phi = kernel.mean[1];
    mean_theta = kernel.mean[2];
    phi_deviation = std::sqrt (sigma (1, 1));
    const double determinant =
        sigma (1, 1) * sigma (2, 2) - sigma (1, 2) * sigma (1, 2);
    inverse_phi_phi_ = sigma (2, 2) / determinant;
    inverse_phi_theta_ = -sigma (1, 2) / determinant;
    inverse_theta_theta_ = sigma (1, 1) / determinant;
    rho_per_phi_ = inverse_phi_phi_ * sigma (0, 1) + inverse_phi_theta_ * sigma (0, 2);
    rho_per_theta_ =
        inverse_phi_theta_ * sigma (0, 1) + inverse_theta_theta_ * sigma (0, 2);
    rho_variance =
        sigma (0, 0) - rho_per_phi_ * sigma (0, 1) - rho_per_theta_ * sigma (0, 2);
    peak = kernel.weight / std::sqrt (8.0 * pi * pi * pi * determinant * rho_variance);
  }

  /** False where the covariance is not positive definite. */
  bool
  isDefined () const
  {
    return std::isfinite (peak) && peak > 0.0;
  }

  /** Squared Mahalanobis distance of a direction, at its likeliest rho, from the mean
   * of the kernel. */
  double
  squaredDeviation (const Offset& offset) const
  {
    return offset.phi * (inverse_phi_phi_ * offset.phi +
                         2.0 * inverse_phi_theta_ * offset.theta) +
           inverse_theta_theta_ * offset.theta * offset.theta;
  }

  /** Offset from the mean theta of the likeliest theta of a row [rad]. */
  double
  likeliestThetaOffset (double phi_offset) const
  {
    return -inverse_phi_theta_ / inverse_theta_theta_ * phi_offset;
  }

  /** Offset from the likeliest theta of a row [rad] at which the squared Mahalanobis
   * distance is larger by squared_deviation. */
  double
  thetaReach (double squared_deviation) const
  {
    return std::sqrt (squared_deviation / inverse_theta_theta_);
  }

  /** Likeliest rho of a direction [m]. */
  double
  likeliestRho (const Offset& offset) const
  {
    return mean_rho + rho_per_phi_ * offset.phi + rho_per_theta_ * offset.theta;
  }

  double mean_rho = 0.0;
  double mean_phi = 0.0;
  double mean_theta = 0.0;
  double phi_deviation = 0.0;
  /** Variance of rho about the likeliest rho of a direction [m^2]. */
  double rho_variance = 0.0;
  /** Weight times the density at the mean. */
  double peak = 0.0;

private:
  // The inverse of the covariance of phi and theta.
  double inverse_phi_phi_ = 0.0;
  double inverse_phi_theta_ = 0.0;
  double inverse_theta_theta_ = 0.0;
  // Slopes of the likeliest rho over phi and theta [m/rad].
  double rho_per_phi_ = 0.0;
  double rho_per_theta_ = 0.0;
};

/** Casts the votes of one kernel, \ref castVotes. */
class VoteCaster {
public:
  VoteCaster (const KernelDensity& density, const HoughSpace& space, KernelVotes& votes)
  : density_ (density)
  , space_ (space)
  , votes_ (votes)
  , ratio_change_ (std::exp (-space.rho_step * space.rho_step / density.rho_variance))
  {}

  /** Casts the votes of all rows near the mean, and that of the bin of the mean. */
  void
  castAll ()
  {
    const double step = space_.directions.phi_step;
    const double reach = // on either side of the mean [rad]
        std::min (std::sqrt (max_squared_deviation) * density_.phi_deviation,
                  max_directions * step);
    const int phi_num = space_.directions.phi_num;
    const int first = clampedToInt (
        std::ceil ((density_.mean_phi - reach) / step), -phi_num, 2 * phi_num);
    const int last = clampedToInt (
        std::floor ((density_.mean_phi + reach) / step), -phi_num, 2 * phi_num);
    for (int row = first; row <= last; ++row)
      castRow (row);
    castBinOfMean();
    if (has_wrapped_)
      keepLargestVotes();
  }

private:
  /** Casts the votes of a row of directions.
   * \param[in] row may lie beyond a pole, as in \ref BallDirections::at */
  void
  castRow (int row)
  {
    const BallDirections& directions = space_.directions;
    const double phi_offset = row * directions.phi_step - density_.mean_phi;
    const double squared_deviation_left =
        max_squared_deviation -
        phi_offset * phi_offset / (density_.phi_deviation * density_.phi_deviation);
    if (squared_deviation_left < 0.0)
      return;
    const bool is_beyond_pole = row < 0 || row > directions.phi_num;
    if (is_beyond_pole)
      has_wrapped_ = true;
    const int reflected = reflectedRow (row);
    const double theta_offset = density_.likeliestThetaOffset (phi_offset);
    const int patches = directions.patchesOfRow (reflected);
    if (patches == 1) { // All azimuths meet at a pole.
      castRay (directions.patchOfRow (reflected, 0), {phi_offset, theta_offset});
      return;
    }

    // Azimuth of the mean, counted on the side of the pole where the row is.
    const double mean_theta = density_.mean_theta + (is_beyond_pole ? pi : 0.0);
    const double step = 2.0 * pi / patches;
    const double middle_patch = (mean_theta + theta_offset) / step - 0.5;
    const double reach = std::min ({density_.thetaReach (squared_deviation_left) / step,
                                    0.5 * patches,
                                    max_directions});
    // At most all patches of the row, each once.
    const int first =
        clampedToInt (std::ceil (middle_patch - reach), -max_patches, max_patches);
    const int last = std::min (
        clampedToInt (std::floor (middle_patch + reach), -max_patches, max_patches),
        first + patches - 1);
    for (int patch = first; patch <= last; ++patch)
      castRay (directions.patchOfRow (reflected, patch),
               {phi_offset, (patch + 0.5) * step - mean_theta});
  }

  /** The row on the other side of the pole for a row beyond it; else the row itself. */
  int
  reflectedRow (int row) const
  {
    const int last_row = space_.directions.phi_num;
    if (row < 0)
      return -row;
    if (row > last_row)
      return 2 * last_row - row;
    return row;
  }

  /** Casts the votes of a direction, for rho on both sides of the center.
   * \param[in] offset of the direction from the mean */
  void
  castRay (std::uint32_t direction, const Offset& offset)
  {
    const double squared_deviation = density_.squaredDeviation (offset);
    const double squared_deviation_left =
        std::max (0.0, max_squared_deviation - squared_deviation);
    const double rho = density_.likeliestRho (offset);
    const double step = space_.rho_step;
    const double reach = std::min (
        std::sqrt (squared_deviation_left * density_.rho_variance), max_bins * step);
    // Bins below 0 are those of the opposite direction. The limits of first and last
    // differ, so that a range wholly beyond the bins is empty.
    const int bins = space_.rho_num;
    const int first =
        clampedToInt (std::ceil ((rho - reach) / step - 0.5), -bins, bins);
    const int last =
        clampedToInt (std::floor ((rho + reach) / step - 0.5), -bins - 1, bins - 1);
    const double height = density_.peak * std::exp (-0.5 * squared_deviation);
    if (last < first)
      return;
    if (last >= 0) {
      const int begin = std::max (first, 0);
      addRay (direction, begin, last + 1, space_.rhoOf (begin) - rho, step, height);
    }
    if (first < 0) { // bin -1 is bin 0 of the opposite direction
      has_wrapped_ = true;
      const int nearest = std::min (last, -1);
      const std::uint32_t opposite = space_.directions.opposite (direction);
      addRay (
          opposite, -1 - nearest, -first, space_.rhoOf (nearest) - rho, -step, height);
    }
  }

  /** Adds a ray of the densities at offset, offset + step, .. from the likeliest rho
   * [m]. The ratio of neighboring densities changes by a constant factor, so that no
   * exponential is computed per bin.
   * \param[in] begin, end range of bins, [begin, end)
   * \param[in] height density at the likeliest rho */
  void
  addRay (std::uint32_t direction,
          int begin,
          int end,
          double offset,
          double step,
          double height)
  {
    double value = height * std::exp (-0.5 * offset * offset / density_.rho_variance);
    double ratio = std::exp (-step * (offset + 0.5 * step) / density_.rho_variance);
    const auto first_value = static_cast<std::uint32_t> (votes_.values.size());
    votes_.rays.push_back ({direction, begin, end, first_value});
    for (int bin = begin; bin < end; ++bin) {
      votes_.values.push_back (static_cast<float> (value));
      value *= ratio;
      ratio *= ratio_change_;
    }
  }

  /** Gives the bin of the mean the vote at the border of the ellipsoid, unless its
   * center lies in the ellipsoid and it has a larger vote. */
  void
  castBinOfMean ()
  {
    const BallDirections& directions = space_.directions;
    const int row =
        static_cast<int> (std::lround (density_.mean_phi / directions.phi_step));
    const std::uint32_t direction = directions.at (row, density_.mean_theta);
    const int bin = std::min (static_cast<int> (density_.mean_rho / space_.rho_step),
                              space_.rho_num - 1);
    Offset offset;
    offset.phi = directions.phiOf (direction) - density_.mean_phi;
    if (directions.patchesOfRow (row) == 1)
      offset.theta = density_.likeliestThetaOffset (offset.phi);
    else
      offset.theta = std::remainder (
          directions.thetaOf (direction) - density_.mean_theta, 2.0 * pi);
    const double rho_offset = space_.rhoOf (bin) - density_.likeliestRho (offset);
    const double squared_deviation = density_.squaredDeviation (offset) +
                                     rho_offset * rho_offset / density_.rho_variance;
    if (squared_deviation <= max_squared_deviation)
      return;
    const double height = density_.peak * std::exp (-0.5 * max_squared_deviation);
    addRay (direction, bin, bin + 1, 0.0, 0.0, height);
  }

  /** Of several votes for a bin all but the largest become 0. */
  void
  keepLargestVotes ()
  {
    std::vector<VoteRay>& rays = votes_.rays;
    std::sort (rays.begin(), rays.end(), [] (const VoteRay& a, const VoteRay& b) {
      return std::tie (a.direction, a.first_value) <
             std::tie (b.direction, b.first_value);
    });
    for (auto a = rays.begin(); a != rays.end(); ++a)
      for (auto b = a + 1; b != rays.end() && b->direction == a->direction; ++b)
        keepLargerVote (*a, *b);
  }

  void
  keepLargerVote (const VoteRay& a, const VoteRay& b)
  {
    const int end = std::min (a.end, b.end);
    for (int bin = std::max (a.begin, b.begin); bin < end; ++bin) {
      float& of_a = votes_.values[a.first_value + (bin - a.begin)];
      float& of_b = votes_.values[b.first_value + (bin - b.begin)];
      if (of_a < of_b)
        of_a = 0.0f;
      else
        of_b = 0.0f;
    }
  }

  const KernelDensity& density_;
  const HoughSpace& space_;
  KernelVotes& votes_;
  /** Factor by which the ratio of neighboring votes changes from bin to bin. */
  const double ratio_change_;
  /** Whether votes went beyond a pole or the center, so that rays may overlap. */
  bool has_wrapped_ = false;
};

} // namespace

PlaneKernel
planeKernel (const PlaneFit& fit,
             const Eigen::Matrix3d& covariance,
             const Eigen::Vector3d& center,
             double weight)
{
  const double signed_rho = (fit.centroid - center).dot (fit.plane.normal);
  const Eigen::Vector3d normal = (signed_rho < 0.0 ? -1.0 : 1.0) * fit.plane.normal;
  const double rho = std::abs (signed_rho);
  const double theta = std::atan2 (normal.y(), normal.x());
  const double horizontal = std::hypot (normal.x(), normal.y());
  const double guard = std::sqrt (min_squared_radius);

  // The rows are the derivatives of rho, phi and theta by the point p = rho n of the
  // plane, with w = px^2 + py^2 and q = w + pz^2. The cosine and sine of theta replace
  // px / sqrt (w) and py / sqrt (w), because they stay defined at the poles.
  const double root_w = std::max (rho * horizontal, guard);
  const double root_q = std::max (rho, guard);
  Eigen::Matrix3d jacobian;
  jacobian.row (0) = normal;
  jacobian.row (1) << std::cos (theta) * normal.z(), std::sin (theta) * normal.z(),
      -horizontal;
  jacobian.row (1) /= root_q;
  jacobian.row (2) << -std::sin (theta) / root_w, std::cos (theta) / root_w, 0.0;

  const double phi = std::acos (std::clamp (normal.z(), -1.0, 1.0));
  PlaneKernel kernel{
      {rho, phi, theta}, jacobian * covariance * jacobian.transpose(), weight};
  kernel.covariance (0, 0) += min_rho_variance;
  return kernel;
}

void
castVotes (const PlaneKernel& kernel, const HoughSpace& space, KernelVotes& votes)
{
  votes.rays.clear();
  votes.values.clear();
  const KernelDensity density (kernel);
  if (density.isDefined())
    VoteCaster (density, space, votes).castAll();
}

} // namespace pcl_ops::internal
