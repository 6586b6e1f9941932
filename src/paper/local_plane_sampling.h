// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/random.h"
#include "cloud/points.h"
#include <pcl_ops/fast_sampling_plane_filtering.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace pcl_ops::internal {

using LocalSamplingParameters = FastSamplingPlaneFilteringParameters::Local;

/** \brief A function that finds the points within r2 of the point \p center, itself
 * included. It overwrites \p sphere with their indices, in any order. All indices are
 * those of \ref Spheres::points. It returns how many points were examined: far more
 * than \p sphere has where a nearly empty sphere lies close to many points. */
using SphereFinder = std::function<std::size_t (std::uint32_t center, Indices& sphere)>;

/** \brief Points in the order of a search, and the function that finds the sphere
 * around a point. */
struct Spheres {
  Coordinates points;
  SphereFinder find;
};

/** \brief Spheres of radius r2, found by the user's search if one is set, else in a
 * grid of voxels, which takes less time to build than a k-d tree. Both \p input and \p
 * points must outlive the spheres.
 * \param[in] radius r2 [m] */
Spheres
spheresAround (const DetectorInput& input,
               const Points& points,
               double radius,
               unsigned threads);

/** \brief Draws a hypothesis: the plane through a point p_r0 and two points near it.
 * \param[in] origin index of p_r0
 * \param[in] sphere indices of the points around p_r0, at least one
 * \param[in] inner_radius r1: largest distance of p_r1 and p_r2 from p_r0 [m]. A point
 * that is too far away or equals p_r0 is drawn again; if the three lie on one line,
 * both are drawn again
 * \return nothing if 1000 draws give no triangle */
std::optional<Plane>
drawHypothesis (const Coordinates& points,
                std::uint32_t origin,
                const Indices& sphere,
                double inner_radius,
                RandomGenerator& generator);

/** \brief Planes sampled from spheres. */
struct LocalPlanes {
  /** \brief Moments of the inliers of each plane, about the zero of the points' frame,
   * in the order the planes were found. */
  std::vector<Moments> moments;
  /** \brief k: how many spheres were tried, with or without a hypothesis. */
  std::size_t hypotheses = 0;
};

/** \brief Samples planes from small spheres until N_max, K_max or the limit of visits
 * (Local::max_visits_per_point) is reached: the paper's Algorithm 2.
 *
 * A sphere with fewer than N_loc points has no plane. As in the paper, a point that a
 * plane has taken may be drawn again: spheres overlap, and merging joins their planes.
 * \param[in] distance_threshold theta_h: inliers are nearer to the plane [m] */
LocalPlanes
sampleLocalPlanes (const Coordinates& points,
                   const SphereFinder& find_sphere,
                   const LocalSamplingParameters& parameters,
                   double distance_threshold,
                   std::uint32_t seed);

} // namespace pcl_ops::internal
