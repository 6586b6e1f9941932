// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/export.h>
#include <pcl_ops/plane.h>

#include <optional>
#include <vector>

namespace pcl_ops {

/** \brief Parameters of the merging process of all detectors (paper section III-C). A
 * detector chooses values that are not given. The members also say which value \ref
 * mergePlanes uses if it is called without a detector. */
struct MergingParameters {
  /** \brief False: planes are not merged. But Sampling::Neighborhoods and
   * Sampling::Surfels still join pieces that touch. */
  bool enabled = true;
  /** \brief Largest angle between the normals [rad]. */
  double angle_threshold = paper_angle_tolerance;
  /** \brief Largest distance of either centroid to the other plane [m]. Not given: the
   * detector's theta_h; with Sampling::Neighborhoods and Sampling::Surfels the distance
   * is not tested and only the noise decides. Without a detector: 0.05 m. */
  std::optional<double> distance_threshold;
  /** \brief A second test, not in the paper: planes within the angle are also merged if
   * the rms distance of the smaller one's points to the larger plane is below this many
   * times their noise. The noise of a plane is its rms distance. The larger of the two
   * noises counts, but at most 6 times the smaller one. With Sampling::Neighborhoods
   * the factor limits the distance of planes that are joined over a gap, in units of
   * the noise of their surroundings. Not given: 2 with Sampling::Neighborhoods; 1.5
   * with Sampling::Surfels, because real walls are not flat; 0 (no second test)
   * elsewhere. */
  std::optional<double> noise_factor;
};

namespace detail {

/** \brief The coplanarity test on a pair of planes (paper section III-C).
 * \return true if the angle between the normals [rad] and the distances of both
 * centroids to the other plane [m] are below the thresholds */
PCL_OPS_EXPORT bool
areCoplanar (const PlaneFit& first,
             const PlaneFit& second,
             double angle_threshold,
             double distance_threshold);

} // namespace detail

/** \brief The planes after merging. */
struct MergedPlanes {
  /** \brief Moments of each merged plane, by descending count. Input planes whose
   * points span no plane (fewer than three points, or all on one line) are dropped. */
  std::vector<Moments> moments;
  /** \brief Least squares fits to \ref moments. */
  std::vector<PlaneFit> fits;
  /** \brief For each input plane, the index of the merged plane in \ref moments, or
   * \ref no_plane if it was dropped. */
  Labels merged_into;
};

/** \brief Merges coplanar planes until no pair passes the test. Each merge adds the
 * moments of the smaller plane to the larger one and refits it at once. So its time
 * does not depend on the number of points.
 * \param[in] planes moments of each plane's points, all in one frame
 * \param[in] parameters the thresholds, which are not checked; no pair passes a NaN */
PCL_OPS_EXPORT MergedPlanes
mergePlanes (const std::vector<Moments>& planes, const MergingParameters& parameters);

} // namespace pcl_ops
