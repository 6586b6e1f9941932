// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/export.h>
#include <pcl_ops/plane.h>

#include <optional>
#include <vector>

namespace pcl_ops {

/** \brief Parameters of the merging process of all detectors (paper section III-C). A
 * detector fills in what is not given; where \ref mergePlanes is called alone, each
 * member says what stands in. */
struct MergingParameters {
  /** \brief Off: planes are left as they were found. Neighborhoods and surfels still
   * join pieces that touch. */
  bool enabled = true;
  /** \brief Largest angle between the normals [rad]. */
  double angle_threshold = paper_angle_tolerance;
  /** \brief Largest distance of either centroid to the other plane [m]. Not given: the
   * detector's theta_h; with Sampling::Neighborhoods and Sampling::Surfels the noise
   * decides alone. Without a detector: 0.05 m. */
  std::optional<double> distance_threshold;
  /** \brief Planes within the angle are one, too, if the rms distance of the smaller
   * one's points to the larger plane is below this many times the noise of the noisier
   * one, which counts as at most 6 times that of the cleaner one; the noise of a plane
   * is the rms distance of its points to it. Not in the paper. With
   * Sampling::Neighborhoods it is how many noises of their surroundings planes are
   * apart that are joined over a gap, too. Not given: 2 with
   * Sampling::Neighborhoods, 1.5 with Sampling::Surfels, whose surfaces, as real walls,
   * are not flat; 0 elsewhere.
   */
  std::optional<double> noise_factor;
};

namespace detail {

/** \brief The coplanarity test on a pair of planes: the angle between the normals, and
 * both distances of a centroid to the other plane, are below the thresholds. */
PCL_OPS_EXPORT bool
areCoplanar (const PlaneFit& first,
             const PlaneFit& second,
             double angle_threshold,
             double distance_threshold);

} // namespace detail

/** \brief The planes after merging. */
struct MergedPlanes {
  /** \brief Moments of each, by falling count. Sets without a plane (fewer than three
   * points, or all on one line) are dropped. */
  std::vector<Moments> moments;
  /** \brief The least squares plane of each. */
  std::vector<PlaneFit> fits;
  /** \brief For each plane put in, the position of the one it went into, or
   * \ref no_plane where it was dropped. */
  Labels merged_into;
};

/** \brief Merges coplanar planes until no pair passes the test. The larger plane takes
 * the smaller; moments are added and the plane refitted at once, so that a merge costs
 * O(1) however many points the planes have.
 * \param[in] planes moments of each plane's points, all in one frame
 * \param[in] parameters thresholds */
PCL_OPS_EXPORT MergedPlanes
mergePlanes (const std::vector<Moments>& planes, const MergingParameters& parameters);

} // namespace pcl_ops
