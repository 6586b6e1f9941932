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

/** \brief Gives the points within r2 of the point at a position, itself included: their
 * positions, in any order, replace what the vector held.
 * \return how many points were looked at for that; more than there are in the sphere,
 * if it is nearly empty in a crowd */
using SphereFinder = std::function<std::size_t (std::uint32_t center, Indices& sphere)>;

/** \brief Points in the order a search has them, and the spheres around each. */
struct Spheres {
  Coordinates points;
  SphereFinder find;
};

/** \brief Spheres of radius r2 by the user's search, or, several times faster, in a
 * grid of voxels; input and points are used as long as the spheres are. */
Spheres
spheresAround (const DetectorInput& input,
               const Points& points,
               double radius,
               unsigned threads);

/** \brief A point and the plane through it and two others near it.
 * \param[in] origin position of p_r0
 * \param[in] sphere positions of the points around it, at least one
 * \param[in] inner_radius r1: how far away p_r1 and p_r2 may be [m]; both are drawn anew
 * while the three are not different points or are on one line
 * \return nothing if a bounded number of draws gives no triangle */
std::optional<Plane>
drawHypothesis (const Coordinates& points,
                std::uint32_t origin,
                const Indices& sphere,
                double inner_radius,
                RandomGenerator& generator);

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
 * \param[in] distance_threshold theta_h: largest distance of an inlier [m] */
LocalPlanes
sampleLocalPlanes (const Coordinates& points,
                   const SphereFinder& find_sphere,
                   const LocalSamplingParameters& parameters,
                   double distance_threshold,
                   std::uint32_t seed);

} // namespace pcl_ops::internal
