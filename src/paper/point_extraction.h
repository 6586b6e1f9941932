// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/random.h"
#include "paper/oriented_points.h"
#include <pcl_ops/oriented_point_sampling.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace pcl_ops::internal {

/** \brief Those of Sampling::Points, theta_h given. */
using RansacParameters = OrientedPointSamplingParameters;

/** \brief N_iter = log (1 - p) / log (1 - w): draws of one point after which an inlier
 * was among them with probability p.
 * \param[in] inlier_ratio w = 1 - e; outside (0, 1) it is guarded: w >= 1 needs one
 * draw, w <= 0 as many as fit */
std::size_t
requiredDraws (double probability, double inlier_ratio);

/** \brief Samples no plane has yet, and what hypotheses are counted on. */
struct Candidates {
  const OrientedSamples& samples;
  /** \brief Which of the samples, ascending. */
  Indices left;
  /** \brief All points no plane has yet, for hypotheses to compete on these ("using all
   * points for verification"; Verification::AllPoints); else nullptr. */
  Coordinates* remaining = nullptr;
};

/** \brief One-point RANSAC on sampled points (paper section III-A, Algorithm 1, lines 7
 * to 24): a sample's own plane, drawn N_iter times, N_iter adapted to the best inlier
 * ratio so far. theta_N is counted on the samples,
 * whatever hypotheses compete on.
 * \return the hypothesis with the most inliers; nothing if none has more than theta_N */
std::optional<Plane>
onePointRansac (const Candidates& candidates,
                const RansacParameters& parameters,
                RandomGenerator& generator);

/** \brief A plane with the samples on it. */
struct ExtractedPlane {
  Plane plane;
  Indices inliers;
};

/** \brief The largest plane of the candidates, refitted to its inliers among them; with
 * local optimization these are selected again while they grow in number (LO-RANSAC,
 * Chum, Matas & Kittler 2003). */
std::optional<ExtractedPlane>
largestPlane (const Candidates& candidates,
              const RansacParameters& parameters,
              RandomGenerator& generator);

/** \brief The peel loop (paper, "Detection of Multiple Planes"): finds the largest
 * plane, removes its inliers and repeats until none is found.
 * \param[in,out] candidates what no plane has is left
 * \return the planes in the order found; their inliers are disjoint */
std::vector<ExtractedPlane>
extractAll (Candidates& candidates,
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
