// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/plane.h>
#include <pcl_ops/plane_assignment.h>

#include <cstdint>
#include <vector>

namespace pcl_ops {

/** \brief The merging process of all detectors (paper section III-C). */
struct MergingParameters {
  /** \brief Off: planes are left as they were found. */
  bool enabled = true;
  /** \brief Largest angle between the normals [rad]; default 7 degrees. */
  double angle_threshold = 0.12217304763960307;
  /** \brief Largest distance of either centroid to the other plane [m]; 0: theta_h. */
  double distance_threshold = 0.0;
  /** \brief That distance in units of the noise, if more: the rms distance of the
   * points to their plane. Not in the paper. */
  double noise_factor = 0.0;
};

/** \brief The coplanarity test on a pair of planes: the angle between the normals, and
 * both distances of a centroid to the other plane, are below the thresholds. */
bool
areCoplanar (const PlaneFit& first,
             const PlaneFit& second,
             double angle_threshold,
             double distance_threshold);

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
 * \param[in] parameters thresholds; its distance_threshold must be above 0 */
MergedPlanes
mergePlanes (const std::vector<Moments>& planes, const MergingParameters& parameters);

/** \brief Replaces every label by the plane it was merged into. */
void
relabel (Labels& labels, const Labels& merged_into, unsigned threads);

/** \brief Merges planes given by the points assigned to them.
 * \param[in] positions the points
 * \param[in,out] labels plane of each point; replaced by the plane it was merged into
 * \param[in] number how many planes \p labels speaks of
 * \param[in] parameters thresholds; its distance_threshold must be above 0
 * \param[in] threads number of threads; 0: all. The result does not depend on it */
MergedPlanes
mergeLabelled (const Coordinates& positions,
               Labels& labels,
               std::size_t number,
               const MergingParameters& parameters,
               unsigned threads);

} // namespace pcl_ops
