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

/** \brief The parameters of Sampling::Points, with a distance_threshold (theta_h). */
using RansacParameters = OrientedPointSamplingParameters;

/** \brief N_iter = log (1 - p) / log (1 - w), rounded up: after so many draws of one
 * point, an inlier was drawn with probability p.
 * \param[in] inlier_ratio w = 1 - e; w >= 1 gives one draw, w <= 0 the largest
 * std::int32_t */
std::size_t
requiredDraws (double probability, double inlier_ratio);

/** \brief The samples and points that are free: that no plane has taken yet. */
struct Candidates {
  const OrientedSamples& samples; // all samples
  /** \brief Indices of the free samples, ascending. */
  Indices free_samples;
  /** \brief The free ones of all points, if inliers of hypotheses are counted among
   * them (Verification::AllPoints, the paper's "use all points for hypotheses
   * verification"); nullptr if inliers are counted among the free samples. */
  Coordinates* free_points = nullptr;
};

/** \brief One-point RANSAC on sampled points (paper section III-A, Algorithm 1, lines 7
 * to 24): each draw takes the plane of one sample as hypothesis. The number of draws
 * N_iter follows the best inlier ratio so far. theta_N always counts samples, even if
 * inliers of hypotheses are counted among all points.
 * \return the hypothesis with the most inliers; nothing if no hypothesis has more than
 * theta_N samples as inliers */
std::optional<Plane>
onePointRansac (const Candidates& candidates,
                const RansacParameters& parameters,
                RandomGenerator& generator);

/** \brief A plane with the ascending indices of the samples on it. */
struct ExtractedPlane {
  Plane plane;
  Indices inliers;
};

/** \brief The best plane of RANSAC among the candidates, fitted to its inlier samples.
 * With local optimization the inliers are selected again and the plane is refitted
 * while the number of inliers grows (LO-RANSAC, Chum, Matas & Kittler 2003). Without it
 * the inliers remain those of the hypothesis.
 * \return nothing if RANSAC finds no plane */
std::optional<ExtractedPlane>
largestPlane (const Candidates& candidates,
              const RansacParameters& parameters,
              RandomGenerator& generator);

/** \brief Finds the largest plane, removes its inliers and repeats until no plane is
 * found (paper, "Detection of Multiple Planes").
 * \param[in,out] candidates the inliers of the planes are removed, and from free_points
 * the points nearer to a plane than theta_h
 * \return the planes in the order they were found; their inliers are disjoint */
std::vector<ExtractedPlane>
extractAll (Candidates& candidates,
            const RansacParameters& parameters,
            RandomGenerator& generator);

/** \brief Returns how many points are nearer to a plane than \p distance_threshold [m].
 * RANSAC spends its time in this loop, which the compiler vectorizes because it is in
 * single precision. */
std::size_t
countWithinDistance (const Coordinates& points,
                     const Plane& plane,
                     double distance_threshold);

/** \brief Returns the candidates that are nearer to a plane than \p distance_threshold
 * [m].
 * \param[in] candidates indices of points; their order is kept */
Indices
selectWithinDistance (const Coordinates& points,
                      const Indices& candidates,
                      const Plane& plane,
                      double distance_threshold);

} // namespace pcl_ops::internal
