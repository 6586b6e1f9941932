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
  /** \brief Lengths that were found from the cloud. A distance threshold that
   * parameters give may be left out: \ref detectInFinitePoints adds it. */
  UsedLengths used = {};
};

/** \brief The merging parameters with theta_h as their distance, as in the paper,
 * unless they have a distance of their own. parameters.distance_threshold (theta_h)
 * must be set.
 */
inline MergingParameters
mergingOf (const PlaneDetectorParameters& parameters)
{
  MergingParameters merging = parameters.merging;
  if (!merging.distance_threshold)
    merging.distance_threshold = *parameters.distance_threshold;
  return merging;
}

/** \brief Fits planes to the points assigned to them and merges them, and labels the
 * points by merged plane. */
LabelledPlanes
mergePlanesOf (AssignedPoints assigned,
               const MergingParameters& parameters,
               unsigned threads);

/** \brief Counts the copies of points as points of their planes, and sorts the planes
 * anew by falling numbers of points. Equations stay as they are: each place counted
 * once. */
void
addCopies (const Points& points, LabelledPlanes& found);

/** \brief The planes in the frame of the input cloud, in the same order, their normals
 * towards the viewpoint. */
std::vector<PlaneSegment>
toSegments (const Points& points,
            const LabelledPlanes& found,
            const Eigen::Vector3d& viewpoint);

/** \brief Drops planes with fewer inliers than \p min_points. */
void
dropSmallPlanes (std::size_t min_points, std::vector<PlaneSegment>& planes);

/** \brief What all detectors begin and end with. Before: takes the finite points, and
 * one of equal ones where many are (\ref distinctPoints). After: makes segments in the
 * frame of the input cloud, drops small ones, names their orientations.
 * \param[in] detect the detector, called as (points, durations), returns LabelledPlanes
 * \param[in] step that the zero of the local frame is a multiple of, \ref finitePoints */
template <typename Detect>
Detection
detectInFinitePoints (const DetectorInput& input,
                      const PlaneDetectorParameters& parameters,
                      Detect&& detect,
                      double step = 0.0)
{
  Detection found;
  const StageClock clock;
  // Nothing later looks for NaN or infinite coordinates again; distinctPlaces alone
  // looks for equal points.
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
  // A viewpoint of zero may be that of the sensor, or never have been set: then normals
  // of planes that cannot have been seen from there turn up.
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
