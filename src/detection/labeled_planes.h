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

/** \brief Planes that a detector found, in the local frame of its points. */
struct LabeledPlanes {
  /** \brief For each point the index of its plane in \ref planes, or no_plane. */
  Labels labels;
  MergedPlanes planes;
  /** \brief Number of planes, or of regions, that were merged into \ref planes or
   * dropped. */
  std::size_t planes_before_merging = 0;
  /** \brief The noise around each plane [m], \ref PlaneSegment::noise; an empty list if
   * the detector does not measure it. */
  std::vector<std::optional<double>> noises = {};
  /** \brief Lengths that the detector estimated from the cloud. It may leave out the
   * distance threshold of the parameters: \ref detectInFinitePoints adds that. */
  UsedLengths used = {};
};

/** \brief Returns the merging parameters. If they have no distance threshold, it
 * becomes theta_h, as in the paper: then \p parameters.distance_threshold must be set.
 */
inline MergingParameters
mergingOf (const PlaneDetectorParameters& parameters)
{
  MergingParameters merging = parameters.merging;
  if (!merging.distance_threshold)
    merging.distance_threshold = *parameters.distance_threshold;
  return merging;
}

/** \brief Fits least squares planes to the assigned points, merges coplanar planes and
 * relabels the points by merged plane. */
LabeledPlanes
mergePlanesOf (AssignedPoints assigned,
               const MergingParameters& parameters,
               unsigned threads);

/** \brief Adds the duplicates of points to the moments of their planes, and sorts the
 * planes again by descending number of points. Plane equations do not change: equal
 * points count once in them. */
void
addCopies (const Points& points, LabeledPlanes& found);

/** \brief Returns the planes in the frame of the input cloud, in the same order, with
 * normals towards the viewpoint.
 * \param[in] viewpoint in the frame of the input cloud */
std::vector<PlaneSegment>
toSegments (const Points& points,
            const LabeledPlanes& found,
            const Eigen::Vector3d& viewpoint);

/** \brief The points of a cloud that the indices of the input choose; all without
 * indices. */
class ChosenPoints {
public:
  /** \brief Keeps a reference to the cloud of the input. */
  explicit ChosenPoints (const DetectorInput& input);

  /** \brief A view of the points while this object exists. */
  CloudView
  view () const;

private:
  CloudView cloud_;
  std::optional<std::vector<float>> chosen_; // x, y and z of each; none: all of cloud_
};

/** \brief Drops planes with fewer inliers than \p min_points. */
void
dropSmallPlanes (std::size_t min_points, std::vector<PlaneSegment>& planes);

/** \brief Runs a detector with the steps that all detectors share. Before: selects the
 * finite points, without missing readings, and without duplicates if there are many
 * (\ref distinctPoints). After: makes segments in the frame of the input cloud, drops
 * small ones, names orientations, and turns normals of unseen planes up.
 * \param[in] detect the detector, called as (points, durations), returns
 * LabeledPlanes; not called without finite points
 * \param[in] step the local origin is a multiple of it [m], so that voxels of a given
 * size begin at the same places in both frames; 0: \ref finitePoints chooses one */
template <typename Detect>
Detection
detectInFinitePoints (const DetectorInput& input,
                      const PlaneDetectorParameters& parameters,
                      Detect&& detect,
                      double step = 0.0)
{
  Detection found;
  const StageClock clock;
  // A viewpoint that is not finite is not known.
  const Eigen::Vector3d viewpoint =
      input.viewpoint.allFinite() ? input.viewpoint : Eigen::Vector3d (0, 0, 0);
  // Detectors do not check for NaN or infinite coordinates again. Only distinctPlaces
  // looks for equal points again.
  const Points points =
      distinctPoints (input.cloud, parameters.threads, input.indices, step);
  LabeledPlanes planes;
  if (points.size() > 0)
    planes = detect (points, found.durations);
  if (!points.copies.empty())
    addCopies (points, planes);
  found.planes = toSegments (points, planes, viewpoint);
  dropSmallPlanes (parameters.min_points, found.planes);
  nameOrientations (
      found.planes, parameters.up_axis.cast<double>(), parameters.angle_tolerance);
  // A zero viewpoint may be the position of the sensor, or was never set. Normals of
  // planes that cannot have been seen from there are turned up.
  if (viewpoint.isZero (0.0))
    turnUnseenUp (ChosenPoints (input).view(),
                  viewpoint,
                  parameters.up_axis.cast<double>(),
                  found.planes);
  found.planes_before_merging = planes.planes_before_merging;
  found.used = planes.used;
  if (!found.used.distance_threshold)
    found.used.distance_threshold = parameters.distance_threshold;
  found.durations.detection = clock.total();
  return found;
}

} // namespace pcl_ops::internal
