// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/plane.h>
#include <pcl_ops/points.h>
#include <pcl_ops/random.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace pcl_ops {

/** \brief Which points of a sphere are the inliers of its plane: the paper says both.
 */
enum class LocalInliers {
  /** \brief All points of the sphere within theta_h of the hypothesis (its text). */
  Sphere,
  /** \brief Those of the N_loc tested points that are (its Algorithm 2). */
  Samples
};

/** \brief How planes are sampled in spheres (paper section III-B, Algorithm 2). */
struct LocalSamplingParameters {
  /** \brief r1: p_r1 and p_r2 are drawn from the points this near to p_r0 [m]. */
  double inner_radius = 0.1;
  /** \brief r2: a hypothesis is tested on the points this near to p_r0 [m]. */
  double outer_radius = 0.2;
  /** \brief N_loc: how many of these it is tested on, drawn with repetition. */
  unsigned local_samples = 80;
  /** \brief alpha_min: it needs more than this share of inliers among them. */
  double min_inlier_fraction = 0.8;
  /** \brief Which points of an accepted sphere count, for its plane and for N_max. */
  LocalInliers inliers = LocalInliers::Sphere;
  /** \brief N_max, as a multiple of the number of points: sampling ends at so many
   * inliers, a point counted as often as it is one. */
  double max_inliers_per_point = 2.0;
  /** \brief K_max, as a multiple of the number of points: sampling ends after so many
   * hypotheses. */
  double max_hypotheses_per_point = 1.0;
  /** \brief Points looked at in all spheres together, as a multiple of the number of
   * points, before sampling gives up: where radii are far too large for the distance
   * threshold, K_max would take hours. Not in the paper; clouds of rooms come to some
   * 10, with LocalInliers::Samples to 100. */
  double max_visits_per_point = 300.0;
};

/** \brief Gives the points within r2 of the point at a position, itself included: their
 * positions, in any order, replace what the vector held. */
using SphereFinder = std::function<void (std::uint32_t centre, Positions& sphere)>;

/** \brief A point and the plane through it and two others near it.
 * \param[in] points the points
 * \param[in] origin position of p_r0
 * \param[in] sphere positions of the points around it, at least one
 * \param[in] inner_radius r1: how far away p_r1 and p_r2 may be [m]
 * \param[in,out] generator draws p_r1 and p_r2, both anew while the three are not
 * different points or are on one line
 * \return nothing if a bounded number of draws gives no triangle */
std::optional<Plane>
drawHypothesis (const Coordinates& points,
                std::uint32_t origin,
                const Positions& sphere,
                double inner_radius,
                RandomGenerator& generator);

/** \brief What a local test is certain to end with. */
enum class LocalVerdict { Open, Accepted, Rejected };

/** \brief The verdict as soon as the samples not yet drawn cannot change it.
 * \param[in] drawn samples so far, at most N_loc
 * \param[in] inliers those of them that are inliers
 * \param[in] parameters N_loc and alpha_min
 * \return Accepted: more than alpha_min N_loc inliers; Rejected: no way to as many */
LocalVerdict
localVerdict (unsigned drawn,
              unsigned inliers,
              const LocalSamplingParameters& parameters);

/** \brief Planes found in spheres. */
struct LocalPlanes {
  /** \brief Moments of each plane's inliers about the zero of the points' frame, in the
   * order found. */
  std::vector<Moments> moments;
  /** \brief k: how many hypotheses were looked at. */
  std::size_t hypotheses = 0;
};

/** \brief Samples planes of small spheres until N_max or K_max is reached.
 *
 * Spheres with fewer than N_loc points have no plane. As in the paper, points stay in
 * the game when a plane has taken them: spheres overlap, merging joins their planes.
 * \param[in] points the points
 * \param[in] find_sphere gives the points within r2 of a point
 * \param[in] parameters radii, test and limits
 * \param[in] distance_threshold theta_h: largest distance of an inlier [m]
 * \param[in] seed the same seed finds the same planes */
LocalPlanes
sampleLocalPlanes (const Coordinates& points,
                   const SphereFinder& find_sphere,
                   const LocalSamplingParameters& parameters,
                   double distance_threshold,
                   std::uint32_t seed);

} // namespace pcl_ops
