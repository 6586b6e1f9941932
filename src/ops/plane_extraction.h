// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/oriented_samples.h>
#include <pcl_ops/plane.h>
#include <pcl_ops/random.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace pcl_ops {

/** \brief One-point RANSAC (paper section III-A, Algorithm 1). */
struct RansacParameters {
  /** \brief theta_h: largest distance of an inlier [m]. */
  double distance_threshold = 0.05;
  /** \brief theta_N: a plane needs more inliers than this among the samples. */
  std::size_t min_inliers = 20;
  /** \brief p: probability that one of the draws is an inlier of the largest plane. */
  double probability = 0.99;
  /** \brief Refit the winner to its inliers and select again while they grow in number
   * (LO-RANSAC, Chum, Matas & Kittler 2003). Off in the paper. */
  bool local_optimisation = true;
};

/** \brief A plane with the candidates on it. */
struct ExtractedPlane {
  Plane plane;
  /** \brief Ascending positions, a subset of the candidates. */
  Positions inliers;
};

/** \brief N_iter = log (1 - p) / log (1 - w): draws of one point after which an inlier
 * was among them with probability p. \param[in] probability p in (0, 1) \param[in]
 * inlier_ratio w = 1 - e; outside (0, 1) it is guarded: w >= 1 needs one draw, w <= 0
 * as many as fit */
std::size_t
requiredDraws (double probability, double inlier_ratio);

/** \brief How many positions lie within a distance of a plane: the loop RANSAC spends
 * its time in, plain single precision so that the compiler vectorizes it. */
std::size_t
countWithinDistance (const Coordinates& positions,
                     const Plane& plane,
                     double distance_threshold);

/** \brief The candidates within a distance of a plane, in order. */
Positions
selectWithinDistance (const Coordinates& positions,
                      const Positions& candidates,
                      const Plane& plane,
                      double distance_threshold);

/** \brief The hypothesis with most inliers: a candidate's own plane, drawn N_iter
 * times, N_iter adapted to the best inlier ratio so far (Algorithm 1, lines 7 to 24).
 * \param[in] samples oriented samples
 * \param[in] candidates the samples to draw from
 * \param[in] verified the positions inliers are counted on; their number is N_h
 * \param[in] parameters theta_h, theta_N and p
 * \param[in,out] generator source of the draws
 * \return nothing if no hypothesis has more than theta_N inliers among the candidates
 * and among \p verified */
std::optional<Plane>
onePointRansac (const OrientedSamples& samples,
                const Positions& candidates,
                const Coordinates& verified,
                const RansacParameters& parameters,
                RandomGenerator& generator);

/** \brief The largest plane of the candidates, refitted to its inliers among them;
 * hypotheses compete on the candidates themselves (Verification::Samples). */
std::optional<ExtractedPlane>
largestPlane (const OrientedSamples& samples,
              const Positions& candidates,
              const RansacParameters& parameters,
              RandomGenerator& generator);

/** \brief As \ref largestPlane, but hypotheses compete on all points no plane has yet
 * ("using all points for verification"; Verification::AllPoints).
 * \param[in] samples oriented samples
 * \param[in] candidates positions of the samples that may be on the plane
 * \param[in] parameters thresholds and the probability of success
 * \param[in,out] generator draws the hypotheses
 * \param[in,out] remaining those points; the winner's inliers are removed from it */
std::optional<ExtractedPlane>
largestPlane (const OrientedSamples& samples,
              const Positions& candidates,
              Coordinates& remaining,
              const RansacParameters& parameters,
              RandomGenerator& generator);

/** \brief The peel loop (paper, "Detection of Multiple Planes"): finds the largest
 * plane, removes its inliers and repeats until none is found. \param[in] candidates
 * positions to share out, ascending \param[in] find_largest (candidates) ->
 * std::optional<ExtractedPlane> \return the planes in the order found; their inliers
 * are disjoint */
template <typename FindLargest>
std::vector<ExtractedPlane>
extractAll (Positions candidates, FindLargest&& find_largest)
{
  std::vector<ExtractedPlane> planes;
  while (std::optional<ExtractedPlane> found = find_largest (candidates)) {
    Positions rest;
    std::set_difference (candidates.begin(),
                         candidates.end(),
                         found->inliers.begin(),
                         found->inliers.end(),
                         std::back_inserter (rest));
    if (rest.size() == candidates.size())
      break;
    candidates = std::move (rest);
    planes.push_back (std::move (*found));
  }
  return planes;
}

} // namespace pcl_ops
