// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/points.h"
#include "geometry/angles.h"
#include "geometry/direction_steps.h"
#include <pcl_ops/visibility.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <vector>

namespace pcl_ops {
namespace {

using namespace internal;

/** \brief A point as seen from a position. */
struct Sighting {
  /** \brief Cell of its direction on a cube around the position. */
  std::uint64_t cell;
  double range; // [m]

  bool
  operator<(const Sighting& other) const
  {
    return std::tie (cell, range) < std::tie (other.cell, other.range);
  }

  bool
  operator!= (const Sighting& other) const
  {
    return cell != other.cell || range != other.range;
  }
};

/** \brief Returns the distance to the center of a scene in units of four times the
 * radius of the scene, but at least 1. The farther the scene, the less directions and
 * relative ranges to its points differ: by this factor. */
double
magnificationFrom (const Eigen::Vector3d& position, const Coordinates& scene)
{
  constexpr double max_radii = 4.0;
  constexpr double largest = 1e7; // so that the index of a cell fits into 64 bits
  Moments moments;
  for (std::size_t i = 0; i < scene.size(); ++i)
    moments.add (scene.x[i], scene.y[i], scene.z[i]);
  const double radius = std::sqrt (moments.covariance().trace());
  const double distance = (moments.centroid() - position).norm();
  return std::clamp (distance / (max_radii * radius), 1.0, largest);
}

// Returns the index of the cell that an offset from the center of the cube points to. A
// face of the cube has room for cells_of_side x cells_of_side cells.
std::uint64_t
cellOf (const Eigen::Vector3d& offset, double magnification)
{
  const double cells_per_radian = 80.0 * magnification;
  const auto cells_of_side =
      static_cast<std::uint64_t> (right_angle * cells_per_radian) + 1u;
  Eigen::Index axis = 0;
  const double depth = offset.cwiseAbs().maxCoeff (&axis);
  // Other is one of the two axes after the depth axis, counted cyclically.
  const auto along = [&] (Eigen::Index other) {
    const double angle = std::atan2 (offset[other % 3], depth) + 0.5 * right_angle;
    return static_cast<std::uint64_t> (angle * cells_per_radian);
  };
  const auto face =
      2 * static_cast<std::uint64_t> (axis) + (offset[axis] < 0.0 ? 1u : 0u);
  return (face * cells_of_side + along (axis + 1)) * cells_of_side + along (axis + 2);
}

// Returns the sightings of points, sorted by cell and range.
std::vector<Sighting>
sightingsFrom (const Eigen::Vector3d& position,
               const Coordinates& points,
               double magnification)
{
  std::vector<Sighting> sightings;
  sightings.reserve (points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d offset = points[i] - position;
    if (const double range = offset.norm(); range > 0.0)
      sightings.push_back ({cellOf (offset, magnification), range});
  }
  std::sort (sightings.begin(), sightings.end());
  // A sensor may give all missing readings one position, which must not count so often.
  constexpr std::size_t max_equal = 256;
  std::size_t kept = 0;
  for (const Sighting& sighting : sightings)
    if (kept < max_equal || sightings[kept - max_equal] != sighting)
      sightings[kept++] = sighting;
  sightings.resize (kept);
  return sightings;
}

/** \brief Whether sorted ranges have a gap with a fifth or more of them on each side:
 * one surface behind another, rather than one surface seen at a low angle. */
bool
areOfTwoSurfaces (const Sighting* sorted, std::size_t count, double magnification)
{
  // of the ranges behind and before the gap
  const double min_ratio = 1.0 + 0.15 / magnification;
  constexpr std::size_t least_part = 5; // a fifth
  const std::size_t min_on_side = (count + least_part - 1) / least_part;
  for (std::size_t i = min_on_side; i <= count - min_on_side; ++i)
    if (sorted[i].range > min_ratio * sorted[i - 1].range)
      return true;
  return false;
}

bool
pointsDown (const PlaneSegment& plane, const Eigen::Vector3d& up)
{
  return plane.orientation != Orientation::Vertical && plane.normal.dot (up) < 0.0;
}

/** \brief Whether a plane is edge-on from a position, and so cannot be seen from there.
 */
bool
isPassing (const PlaneSegment& plane, const Eigen::Vector3d& position)
{
  constexpr double min_sine = 0.02;
  return std::abs (plane.plane().distance (position)) <
         min_sine * (plane.centroid - position).norm();
}

/** \brief Whether a position is too far from the planes to be where a sensor was. */
bool
isFarFrom (const std::vector<PlaneSegment>& planes, const Eigen::Vector3d& position)
{
  constexpr double max_distance = 500.0; // in units of the size of the scene
  const Eigen::Vector3d& center = planes.front().centroid;
  double scene_size = 0.0;
  for (const PlaneSegment& plane : planes) {
    const double spread = std::sqrt (plane.moments.covariance().trace());
    scene_size = std::max (scene_size, (plane.centroid - center).norm() + spread);
  }
  return (center - position).norm() > max_distance * scene_size;
}

} // namespace

double
detail::occludedFraction (const CloudView& cloud, const Eigen::Vector3d& viewpoint)
{
  constexpr std::size_t sample_size = 60000;
  constexpr std::size_t min_points_of_cell = 5;
  if (!viewpoint.allFinite())
    return 0.0;
  const Points points = finitePoints (cloud, 1);
  const Coordinates sample = samplePoints (points, sample_size);
  const Eigen::Vector3d position = viewpoint - points.origin;
  const double magnification = magnificationFrom (position, sample);
  const std::vector<Sighting> sightings =
      sightingsFrom (position, sample, magnification);
  std::size_t counted = 0;  // points in cells with enough points
  std::size_t occluded = 0; // those of them in cells with two surfaces
  for (std::size_t begin = 0, end = 0; begin < sightings.size(); begin = end) {
    while (end < sightings.size() && sightings[end].cell == sightings[begin].cell)
      ++end;
    const std::size_t points_of_cell = end - begin;
    if (points_of_cell < min_points_of_cell)
      continue;
    counted += points_of_cell;
    if (areOfTwoSurfaces (&sightings[begin], points_of_cell, magnification))
      occluded += points_of_cell;
  }
  return counted > 0 ? static_cast<double> (occluded) / static_cast<double> (counted)
                     : 0.0;
}

bool
isSeenFrom (const Eigen::Vector3d& viewpoint, const CloudView& cloud)
{
  constexpr double max_sure_fraction = 0.01;
  constexpr double max_fraction = 0.05; // if the steps cannot tell
  if (!viewpoint.allFinite())
    return false;
  const double occluded = detail::occludedFraction (cloud, viewpoint);
  if (occluded <= max_sure_fraction)
    return true;
  constexpr unsigned one_thread = 1;
  const Points points = finitePoints (cloud, one_thread);
  const StepsSay steps_say = seenByItsSteps (points, viewpoint - points.origin);
  return steps_say == StepsSay::CannotTell ? occluded <= max_fraction
                                           : steps_say == StepsSay::Yes;
}

void
turnUnseenUp (const CloudView& cloud,
              const Eigen::Vector3d& viewpoint,
              const Eigen::Vector3d& up,
              std::vector<PlaneSegment>& planes)
{
  const auto points_down = [&up] (const auto& plane) { return pointsDown (plane, up); };
  // Saves the search through the cloud, which takes some milliseconds.
  if (std::none_of (planes.begin(), planes.end(), points_down))
    return;
  const bool turns_all =
      isFarFrom (planes, viewpoint) || !isSeenFrom (viewpoint, cloud);
  for (PlaneSegment& plane : planes)
    if (points_down (plane) && (turns_all || isPassing (plane, viewpoint)))
      plane.normal = -plane.normal;
}

} // namespace pcl_ops
