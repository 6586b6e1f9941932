// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/stage_clock.h"
#include "cloud/points.h"
#include "detection/plane_assignment.h"
#include <pcl_ops/plane_detector.h>
#include <pcl_ops/visibility.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace pcl_ops::internal {

/** \brief What a detector found, in the local frame of its points. */
struct LabelledPlanes {
  Labels labels;
  MergedPlanes planes;
  std::size_t planes_before_merging = 0;
  /** \brief The noise of the surroundings of each plane [m], \ref PlaneSegment::noise;
   * empty where the detector does not measure it. */
  std::vector<std::optional<double>> noises = {};
  /** \brief A threshold that parameters give need not be repeated. */
  UsedLengths used = {};
};

/** \brief The merging process with theta_h where it has no distance of its own (the
 * paper); theta_h is given. */
inline MergingParameters
mergingOf (const PlaneDetectorParameters& parameters)
{
  MergingParameters merging = parameters.merging;
  if (!merging.distance_threshold)
    merging.distance_threshold = *parameters.distance_threshold;
  return merging;
}

/** \brief Merges planes by the points assigned to them, and labels the points anew. */
LabelledPlanes
mergeAssigned (AssignedPoints assigned,
               const MergingParameters& parameters,
               unsigned threads);

/** \brief The planes that other labels of the points make of those that were found.
 * Planes that have the same number as before keep their noise. */
LabelledPlanes
relabelled (const LabelledPlanes& found, AssignedPoints assigned, unsigned threads);

/** \brief Has the planes of points hold their copies, too, and sorts them anew by their
 * numbers of points: equations stay those of the places. */
void
addCopies (const Points& points, LabelledPlanes& found);

/** \brief The planes in the frame of the input cloud, by falling size, their normals
 * towards the viewpoint. */
std::vector<PlaneSegment>
toSegments (const Points& points,
            const LabelledPlanes& found,
            const Eigen::Vector3d& viewpoint);

/** \brief Takes planes with fewer inliers than this out. */
void
dropSmallPlanes (std::size_t min_points, std::vector<PlaneSegment>& planes);

/** \brief What all detectors begin and end with: the finite points, equal ones as one
 * where they would decide, and the planes among them in the frame of the input cloud.
 * \param[in] detect (points, durations) -> LabelledPlanes
 * \param[in] step of the local frame's zero, \ref finitePoints */
template <typename Detect>
Detection
detectInFinitePoints (const DetectorInput& input,
                      const PlaneDetectorParameters& parameters,
                      Detect&& detect,
                      double step = 0.0)
{
  Detection found;
  const StageClock clock;
  // P: drop NaN, Inf and copies once; nothing later checks again
  const Points points =
      distinctPoints (input.cloud, parameters.threads, input.indices, step);
  LabelledPlanes planes =
      points.size() > 0 ? detect (points, found.durations) : LabelledPlanes();
  if (!points.copies.empty())
    addCopies (points, planes);
  found.planes = toSegments (points, planes, input.viewpoint);
  dropSmallPlanes (parameters.min_points, found.planes);
  nameOrientations (
      found.planes, parameters.up_axis.cast<double>(), parameters.angle_tolerance);
  // A cloud that says 0 0 0 says nothing, unless it was seen from there.
  if (input.viewpoint.isZero (0.0))
    turnUnseenUp (
        input.cloud, input.viewpoint, parameters.up_axis.cast<double>(), found.planes);
  found.planes_before_merging = planes.planes_before_merging;
  found.used = planes.used;
  if (!found.used.distance_threshold)
    found.used.distance_threshold = parameters.distance_threshold;
  found.durations.detection = clock.total();
  return found;
}

} // namespace pcl_ops::internal
