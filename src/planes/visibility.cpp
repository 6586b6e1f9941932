// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/points.h"
#include "geometry/angles.h"
#include "geometry/direction_steps.h"
#include <pcl_ops/visibility.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace pcl_ops {
namespace {

using namespace internal;

/** \brief A point as seen from a place: the cell of its direction on a cube around the
 * place, and its range [m]. */
using Sighting = std::pair<std::uint64_t, double>;

/** \brief Returns by how much directions and ranges to a scene differ less than if its
 * center were four times its radius away; 1 for closer ones.
 * \param[in] place from where the scene is looked at */
double
magnificationFrom (const Eigen::Vector3d& place, const Coordinates& points)
{
  constexpr double max_radii = 4.0;
  Moments moments;
  for (std::size_t i = 0; i < points.size(); ++i)
    moments.add (points.x[i], points.y[i], points.z[i]);
  const double radius = std::sqrt (moments.covariance().trace());
  const double distance = (moments.centroid() - place).norm();
  // No more than what fits into the number of a cell.
  constexpr double largest = 1e7;
  return std::clamp (distance / (max_radii * radius), 1.0, largest);
}

std::uint64_t
cellOf (const Eigen::Vector3d& offset, double magnification)
{
  const double cells_per_radian = 80.0 * magnification;
  const auto face_cells =
      static_cast<std::uint64_t> (right_angle * cells_per_radian) + 1u;
  Eigen::Index axis = 0;
  const double depth = offset.cwiseAbs().maxCoeff (&axis);
  const auto along = [&] (Eigen::Index other) {
    const double angle = std::atan2 (offset[other % 3], depth) + 0.5 * right_angle;
    return static_cast<std::uint64_t> (angle * cells_per_radian);
  };
  const auto face =
      2 * static_cast<std::uint64_t> (axis) + (offset[axis] < 0.0 ? 1u : 0u);
  return (face * face_cells + along (axis + 1)) * face_cells + along (axis + 2);
}

std::vector<Sighting>
sightingsFrom (const Eigen::Vector3d& place,
               const Coordinates& points,
               double magnification)
{
  std::vector<Sighting> sightings;
  sightings.reserve (points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d offset = points[i] - place;
    if (const double range = offset.norm(); range > 0.0)
      sightings.emplace_back (cellOf (offset, magnification), range);
  }
  std::sort (sightings.begin(), sightings.end());
  // A sensor may give all missing readings one place, which must not count as often.
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
areOfTwoSurfaces (const Sighting* first, std::size_t number, double magnification)
{
  const double smallest_ratio = 1.0 + 0.15 / magnification;
  constexpr std::size_t min_share = 5;
  const std::size_t least = (number + min_share - 1) / min_share;
  for (std::size_t i = least; i <= number - least; ++i)
    if (first[i].second > smallest_ratio * first[i - 1].second)
      return true;
  return false;
}

bool
pointsDown (const PlaneSegment& plane, const Eigen::Vector3d& up)
{
  return plane.orientation != Orientation::Vertical && plane.normal.dot (up) < 0.0;
}

/** \brief Whether a plane is edge-on from a place, and so cannot be seen from there. */
bool
isPassing (const PlaneSegment& plane, const Eigen::Vector3d& place)
{
  constexpr double min_sine = 0.02;
  return std::abs (plane.plane().distance (place)) <
         min_sine * (plane.centroid - place).norm();
}

/** \brief Whether a place is too far from the planes to be where a sensor was. */
bool
isFarFrom (const std::vector<PlaneSegment>& planes, const Eigen::Vector3d& place)
{
  constexpr double max_distance_by_reach = 500.0;
  const Eigen::Vector3d& center = planes.front().centroid;
  double reach = 0.0;
  for (const PlaneSegment& plane : planes) {
    const double spread = std::sqrt (plane.moments.covariance().trace());
    reach = std::max (reach, (plane.centroid - center).norm() + spread);
  }
  return (center - place).norm() > max_distance_by_reach * reach;
}

} // namespace

double
detail::occludedFraction (const CloudView& cloud, const Eigen::Vector3d& viewpoint)
{
  constexpr std::size_t looked_at = 60000;
  constexpr std::size_t fewest = 5;
  if (!viewpoint.allFinite())
    return 0.0;
  const Points points = finitePoints (cloud, 1);
  const Eigen::Vector3d place = viewpoint - points.origin;
  const Coordinates sample = samplePoints (points, looked_at);
  const double magnification = magnificationFrom (place, sample);
  const std::vector<Sighting> sightings = sightingsFrom (place, sample, magnification);
  std::size_t hidden = 0;
  std::size_t told = 0;
  for (std::size_t first = 0, last = 0; first < sightings.size(); first = last) {
    while (last < sightings.size() && sightings[last].first == sightings[first].first)
      ++last;
    const std::size_t number = last - first;
    if (number < fewest)
      continue;
    told += number;
    if (areOfTwoSurfaces (&sightings[first], number, magnification))
      hidden += number;
  }
  return told > 0 ? static_cast<double> (hidden) / static_cast<double> (told) : 0.0;
}

bool
isSeenFrom (const Eigen::Vector3d& viewpoint, const CloudView& cloud)
{
  constexpr double next_to_none = 0.01;
  constexpr double largest_share = 0.05;
  if (!viewpoint.allFinite())
    return false;
  const double hidden = detail::occludedFraction (cloud, viewpoint);
  if (hidden <= next_to_none)
    return true;
  const Points points = finitePoints (cloud, 1);
  const StepsSay seen = seenByItsSteps (points, viewpoint - points.origin);
  return seen == StepsSay::CannotTell ? hidden <= largest_share : seen == StepsSay::Yes;
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
