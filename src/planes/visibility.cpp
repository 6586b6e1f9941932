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

constexpr unsigned one_thread = 1;

/** \brief A point as seen from a position. */
struct Sighting {
  /** \brief Index of the cell, on a cube around the position, that contains the
   * direction to the point. */
  std::uint64_t cell;
  /** \brief Distance from the position [m]. */
  double range;

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

/** \brief Returns by how much a far scene must be magnified. The farther a scene is,
 * the less do directions and relative ranges to its points differ. The result is the
 * distance to the center of the scene in units of four times its radius, but at
 * least 1.
 * \param[in] scene points of the scene */
double
magnificationFrom (const Eigen::Vector3d& position, const Coordinates& scene)
{
  // Largest distance without magnification, in units of the radius; chosen by hand.
  constexpr double radii_of_near_scene = 4.0;
  // So the index of a cell fits into 64 bits: a face has 1.3e9 x 1.3e9 cells then.
  constexpr double max_magnification = 1e7;
  Moments moments;
  for (std::size_t i = 0; i < scene.size(); ++i)
    moments.add (scene.x[i], scene.y[i], scene.z[i]);
  const double radius = std::sqrt (moments.covariance().trace());
  const double distance = (moments.centroid() - position).norm();
  // For equal points rounding may make the variance negative, and the quotient NaN:
  // std::max in this argument order turns that into 1.
  const double magnification =
      std::max (1.0, distance / (radii_of_near_scene * radius));
  return std::min (magnification, max_magnification);
}

// Returns the index of the cell that an offset from the center of the cube points to. A
// face of the cube has cells_of_side x cells_of_side cells. The cells of a row have
// successive indices.
// \param[in] magnification cells are smaller by this factor, magnificationFrom
std::uint64_t
cellOf (const Eigen::Vector3d& offset, double magnification)
{
  // Cells of 0.7 degrees; chosen by hand.
  constexpr double cells_per_radian_of_near_scene = 80.0;
  const double cells_per_radian = cells_per_radian_of_near_scene * magnification;
  const auto cells_of_side =
      static_cast<std::uint64_t> (right_angle * cells_per_radian) + 1u;
  Eigen::Index axis = 0;
  const double depth = offset.cwiseAbs().maxCoeff (&axis);
  // Returns the row or column of the cell on its face. Other is one of the two axes
  // after the depth axis, counted cyclically.
  const auto cellAlong = [&] (Eigen::Index other) {
    const double angle = std::atan2 (offset[other % 3], depth) + 0.5 * right_angle;
    return static_cast<std::uint64_t> (angle * cells_per_radian);
  };
  const auto face =
      2 * static_cast<std::uint64_t> (axis) + (offset[axis] < 0.0 ? 1u : 0u);
  return (face * cells_of_side + cellAlong (axis + 1)) * cells_of_side +
         cellAlong (axis + 2);
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
  // A sensor may give all missing readings one position: of equal sightings only so
  // many are kept. The number is chosen by hand.
  constexpr std::size_t max_equal = 256;
  std::size_t kept = 0;
  for (const Sighting& sighting : sightings)
    if (kept < max_equal || sightings[kept - max_equal] != sighting)
      sightings[kept++] = sighting;
  sightings.resize (kept);
  return sightings;
}

/** \brief Whether the ranges of sightings have a gap with a fifth or more of them on
 * each side: one surface behind another, rather than one surface seen at a low angle.
 * \param[in] sorted \p count sightings by ascending range
 * \param[in] magnification of the scene, \ref magnificationFrom: gaps may be smaller by
 * this factor */
bool
areOfTwoSurfaces (const Sighting* sorted, std::size_t count, double magnification)
{
  // Smallest gap over the range before it, if the scene is not magnified; chosen by
  // hand.
  constexpr double min_relative_gap = 0.15;
  const double min_ratio = 1.0 + min_relative_gap / magnification; // of both ranges
  const std::size_t min_on_side = (count + 4) / 5; // a fifth, rounded up
  for (std::size_t i = min_on_side; i <= count - min_on_side; ++i)
    if (sorted[i].range > min_ratio * sorted[i - 1].range)
      return true;
  return false;
}

/** \brief Whether the normal of a plane points down, unless the plane is vertical. */
bool
pointsDown (const PlaneSegment& plane, const Eigen::Vector3d& up)
{
  return plane.orientation != Orientation::Vertical && plane.normal.dot (up) < 0.0;
}

/** \brief Whether a plane is edge-on from a position, and so cannot be seen from there.
 */
bool
isEdgeOn (const PlaneSegment& plane, const Eigen::Vector3d& position)
{
  // Sine of the angle between the plane and the direction to its centroid: of 1.1
  // degrees; chosen by hand.
  constexpr double min_sine = 0.02;
  return std::abs (plane.plane().distance (position)) <
         min_sine * (plane.centroid - position).norm();
}

/** \brief Whether a position is too far from the planes to be that of a sensor.
 * \param[in] planes at least one */
bool
isFarFrom (const std::vector<PlaneSegment>& planes, const Eigen::Vector3d& position)
{
  constexpr double max_distance = 500.0; // in units of scene_size; chosen by hand
  const Eigen::Vector3d& center = planes.front().centroid;
  // The largest distance of a plane from the center, with the extent of the plane [m].
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
  // Both are chosen by hand.
  constexpr std::size_t sample_size = 60000;
  constexpr std::size_t min_points_of_cell = 5;
  if (!viewpoint.allFinite())
    return 0.0;
  const Points points = finitePoints (cloud, one_thread);
  const Coordinates sample = samplePoints (points, sample_size);
  const Eigen::Vector3d position = viewpoint - points.origin;
  const double magnification = magnificationFrom (position, sample);
  const std::vector<Sighting> sightings =
      sightingsFrom (position, sample, magnification);
  std::size_t counted = 0;  // number of points in cells with enough points
  std::size_t occluded = 0; // number of those in cells with two surfaces
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
  // From the position of a sensor few points are occluded: visibility.h has measured
  // fractions. Up to this one the points were surely measured from the viewpoint.
  constexpr double max_sure_fraction = 0.01;
  // Up to this fraction they probably were, if the steps between directions cannot
  // tell.
  constexpr double max_probable_fraction = 0.05;
  if (!viewpoint.allFinite())
    return false;
  const double occluded = detail::occludedFraction (cloud, viewpoint);
  if (occluded <= max_sure_fraction)
    return true;
  const Points points = finitePoints (cloud, one_thread);
  const StepsSay steps_say = seenByItsSteps (points, viewpoint - points.origin);
  return steps_say == StepsSay::CannotTell ? occluded <= max_probable_fraction
                                           : steps_say == StepsSay::Yes;
}

void
turnUnseenUp (const CloudView& cloud,
              const Eigen::Vector3d& viewpoint,
              const Eigen::Vector3d& up,
              std::vector<PlaneSegment>& planes)
{
  const auto isTurnable = [&up] (const PlaneSegment& plane) {
    return pointsDown (plane, up);
  };
  // Save the search through the cloud, which takes some milliseconds.
  if (std::none_of (planes.begin(), planes.end(), isTurnable))
    return;
  const bool turns_all =
      isFarFrom (planes, viewpoint) || !isSeenFrom (viewpoint, cloud);
  for (PlaneSegment& plane : planes)
    if (isTurnable (plane) && (turns_all || isEdgeOn (plane, viewpoint)))
      plane.normal = -plane.normal;
}

} // namespace pcl_ops
