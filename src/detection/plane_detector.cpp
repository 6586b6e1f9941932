// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_ops/plane_detector.h>

#include <cmath>

namespace pcl_ops {

std::string
problemOf (const PlaneDetectorParameters& parameters, bool threshold_may_follow_noise)
{
  constexpr double right_angle = 1.5707963267948966;
  const MergingParameters& merging = parameters.merging;
  const double threshold = parameters.distance_threshold;
  const bool follows_noise = threshold == 0.0 && threshold_may_follow_noise;
  if (!(follows_noise || (threshold > 0.0 && std::isfinite (threshold))))
    return "the distance threshold must be a length above 0";
  if (!parameters.up_axis.allFinite() || parameters.up_axis.isZero (0.0f))
    return "the up axis must be a finite vector other than zero";
  if (!(parameters.angle_tolerance >= 0.0 && parameters.angle_tolerance <= right_angle))
    return "the angle tolerance must be between 0 and pi/2 (radians)";
  if (!(merging.angle_threshold >= 0.0 && merging.angle_threshold <= right_angle))
    return "the merging angle must be between 0 and pi/2 (radians)";
  if (!(merging.distance_threshold >= 0.0 &&
        std::isfinite (merging.distance_threshold)))
    return "the merging distance must be 0 (as the distance threshold) or a length";
  if (!(merging.noise_factor >= 0.0 && std::isfinite (merging.noise_factor)))
    return "the merging noise factor must be 0 or more";
  return std::string();
}

namespace {

PlaneSegment
toSegment (const Moments& moments,
           const PlaneFit& fit,
           const Eigen::Vector3d& local_viewpoint)
{
  const bool faces_sensor = fit.plane.distance (local_viewpoint) >= 0.0;
  PlaneSegment segment;
  segment.normal =
      faces_sensor ? fit.plane.normal : Eigen::Vector3d (-fit.plane.normal);
  segment.centroid = fit.centroid;
  segment.moments = moments.about (fit.centroid);
  segment.inliers.resize (static_cast<std::size_t> (moments.count));
  return segment;
}

// Writes each label's indices to its segment, which has room for them. Points that
// follow each other mostly share a plane: its place to write to stays in a register.
void
addInliers (const Points& points,
            const Labels& labels,
            std::vector<PlaneSegment>& segments)
{
  std::vector<pcl::index_t*> next;
  next.reserve (segments.size());
  for (PlaneSegment& segment : segments)
    next.push_back (segment.inliers.data());
  for (std::size_t i = 0; i < labels.size();) {
    const std::int32_t label = labels[i];
    if (label == no_plane) {
      ++i;
      continue;
    }
    pcl::index_t* place = next[static_cast<std::size_t> (label)];
    for (; i < labels.size() && labels[i] == label; ++i)
      *place++ = points.indexOf (i);
    next[static_cast<std::size_t> (label)] = place;
  }
}

} // namespace

std::vector<PlaneSegment>
toSegments (const Detection& detection,
            const Eigen::Vector3d& viewpoint,
            const PlaneDetectorParameters& parameters)
{
  const Points& points = detection.points;
  std::vector<PlaneSegment> segments;
  segments.reserve (detection.planes.fits.size());
  for (std::size_t p = 0; p < detection.planes.fits.size(); ++p)
    segments.push_back (toSegment (detection.planes.moments[p],
                                   detection.planes.fits[p],
                                   viewpoint - points.origin));
  addInliers (points, detection.labels, segments);
  for (PlaneSegment& segment : segments) {
    segment.centroid += points.origin;
    segment.moments.origin += points.origin;
  }
  nameOrientations (
      segments, parameters.up_axis.cast<double>(), parameters.angle_tolerance);
  return segments;
}

} // namespace pcl_ops
