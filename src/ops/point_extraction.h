// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/random.h"
#include "ops/one_point_ransac.h"
#include "ops/oriented_points.h"

#include <optional>
#include <vector>

namespace pcl_ops::internal {

/** \brief One-point RANSAC on sampled points (paper section III-A, Algorithm 1). */
struct RansacParameters {
  /** \brief theta_h: largest distance of an inlier [m]. */
  double distance_threshold = 0.05;
  /** \brief theta_N: a plane needs more inliers than this among the samples. */
  std::size_t min_inliers = 20;
  /** \brief p: probability that one of the draws is an inlier of the largest plane. */
  double probability = 0.99;
  /** \brief Refit the winner to its inliers and select again while they grow in number.
   * Off in the paper. */
  bool local_optimization = true;
};

/** \brief Samples no plane has yet, and what hypotheses are counted on. */
class PointCandidates {
public:
  /** \param[in] samples oriented samples; used as long as this is
   * \param[in] candidates which of them, ascending
   * \param[in] parameters used as long as this is */
  PointCandidates (const OrientedSamples& samples,
                   Indices candidates,
                   const RansacParameters& parameters);

  /** \brief Lets hypotheses compete on all points no plane has yet instead ("using all
   * points for verification"; Verification::AllPoints).
   * \param[in,out] remaining those points; each plane's inliers are removed from it */
  void
  verifyOn (Coordinates& remaining)
  {
    remaining_ = &remaining;
  }

  std::size_t
  size () const
  {
    return candidates_.size();
  }

  const Indices&
  indices () const
  {
    return candidates_;
  }

  bool
  mayHoldPlane () const
  {
    return size() > parameters_.min_inliers;
  }
  Plane
  planeOf (std::uint32_t candidate) const;
  Vote
  leastVote () const;
  Vote
  vote (const Plane& hypothesis) const;
  /** \brief theta_N is counted on the samples, whatever hypotheses compete on. */
  bool
  suffices (const Plane& hypothesis, const Vote& vote) const;

  Support
  select (const Plane& plane) const;

  void
  remove (const Peel& peel);

private:
  const OrientedSamples& samples_;
  Indices candidates_;
  const RansacParameters& parameters_;
  /** \brief The candidates' coordinates. */
  Coordinates gathered_;
  Coordinates* remaining_ = nullptr;
};

/** \brief The largest plane of the candidates, refitted to its inliers among them. */
std::optional<Peel>
largestPlane (const PointCandidates& candidates,
              const RansacParameters& parameters,
              RandomGenerator& generator);

/** \brief How many points lie within a distance of a plane: the loop RANSAC spends its
 * time in, plain single precision so that the compiler vectorizes it. */
std::size_t
countWithinDistance (const Coordinates& points,
                     const Plane& plane,
                     double distance_threshold);

/** \brief The candidates within a distance of a plane, in order. */
Indices
selectWithinDistance (const Coordinates& points,
                      const Indices& candidates,
                      const Plane& plane,
                      double distance_threshold);

} // namespace pcl_ops::internal
