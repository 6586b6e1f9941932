// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/direction_steps.h"

#include "geometry/angles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

namespace pcl_ops::internal {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

// Numbers in this file for which no reason is given were chosen by hand.

/** \brief A unit direction, and the cell of a cube map that contains it: a cube around
 * the position whose six faces are divided into cells. */
struct Direction {
  std::uint32_t cell;
  Vector3f unit;
};

// The cells are 0.4 degrees wide, a few angular steps of a sensor. So a face, which is
// a right angle wide, has 236 x 236 cells. It has indices for cells_of_side x
// cells_of_side cells, of which a power of two above 236 is enough.
constexpr double cells_per_radian = 150.0;
constexpr std::uint32_t cells_of_side = 512;

// Returns the index of the cell that an offset from the center of the cube points to.
// The cells of a row have successive indices; the next row begins cells_of_side later.
std::uint32_t
cellOf (const Vector3d& offset)
{
  Eigen::Index axis = 0;
  const double depth = offset.cwiseAbs().maxCoeff (&axis);
  // Returns the row or column of the cell on its face. Other is one of the two axes
  // after the depth axis, counted cyclically.
  const auto cellAlong = [&] (Eigen::Index other) {
    const double angle = std::atan2 (offset[other % 3], depth) + 0.5 * right_angle;
    // From 1 on: the empty cells at borders keep cells of two faces apart.
    return 1u + static_cast<std::uint32_t> (angle * cells_per_radian);
  };
  const auto face =
      2 * static_cast<std::uint32_t> (axis) + (offset[axis] < 0.0 ? 1u : 0u);
  return (face * cells_of_side + cellAlong (axis + 1)) * cells_of_side +
         cellAlong (axis + 2);
}

// Whether direction a comes before direction b in a list sorted by cell.
bool
isBefore (const Direction& a, const Direction& b)
{
  return std::make_tuple (a.cell, a.unit.x(), a.unit.y(), a.unit.z()) <
         std::make_tuple (b.cell, b.unit.x(), b.unit.y(), b.unit.z());
}

/** \brief Returns a hash, 0 to 65535, of the part of the view that an offset points to.
 * Parts are some 4 degrees wide, many angular steps of a sensor: a sample of parts
 * keeps the neighbors of most directions in it, unlike a sample of points. */
std::uint32_t
partOf (const Vector3d& offset)
{
  constexpr double parts_per_half_side = 16.0;       // of a face of a cube
  constexpr std::uint32_t hash_factor = 2654435761u; // by Knuth: 2^32 / golden ratio
  Eigen::Index axis = 0;
  const double depth = offset.cwiseAbs().maxCoeff (&axis);
  const Vector3d part = (offset / depth * parts_per_half_side).array().round();
  // Coordinates are -16 to 16 and the factors 1, 100 and 10000, so that each part has a
  // number of its own.
  const auto number = static_cast<std::uint32_t> (
      static_cast<std::int32_t> (part.x() + 100.0 * part.y() + 10000.0 * part.z()));
  return number * hash_factor >> 16;
}

/** \brief Returns the distinct unit directions to the points in a sample of parts of
 * the view, sorted by cell; empty if more than three quarters of the directions are
 * equal to others. */
std::vector<Direction>
directionsOf (const Coordinates& points, const Vector3d& position)
{
  // Largest angle between equal directions [rad]: far above the rounding of unit
  // vectors (1e-7), far below the steps of a sensor (1e-3).
  constexpr float same_direction = 1e-5f;
  constexpr std::size_t wanted_points = 30000; // limits the time
  // About one part of this many is used.
  const auto parts_per_used =
      static_cast<std::uint32_t> (points.size() / wanted_points + 1);
  std::vector<Direction> directions;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector3d offset = points[i] - position;
    if (offset.isZero (0.0))
      continue;
    const bool is_used = parts_per_used == 1 || partOf (offset) % parts_per_used == 0;
    if (!is_used)
      continue;
    directions.push_back ({cellOf (offset), offset.normalized().cast<float>()});
  }
  std::sort (directions.begin(), directions.end(), isBefore);
  const auto areSame = [] (const Direction& a, const Direction& b) {
    return a.cell == b.cell &&
           (a.unit - b.unit).squaredNorm() < same_direction * same_direction;
  };
  // If many directions are equal, coordinates were rounded to a coarse grid: then steps
  // are even seen from any position, and tell nothing.
  constexpr std::size_t max_points_per_direction = 4;
  const std::size_t points_in_parts = directions.size();
  directions.erase (std::unique (directions.begin(), directions.end(), areSame),
                    directions.end());
  if (max_points_per_direction * directions.size() < points_in_parts)
    directions.clear();
  return directions;
}

/** \brief Returns the angle from a direction to the nearest other one in the 3 x 3
 * cells around it [rad]. Returns nothing if these cells have no other direction, or if
 * a row of three cells has more directions than a sensor has in so small a part of the
 * view.
 * \param[in] directions sorted by cell */
std::optional<float>
stepAt (const std::vector<Direction>& directions, const Direction& from)
{
  constexpr std::ptrdiff_t max_in_three_cells = 1200; // limits the time, too
  // The angle is nearly the distance of the unit vectors.
  float least_squared_distance = std::numeric_limits<float>::infinity();
  for (const std::uint32_t middle_cell :
       {from.cell - cells_of_side, from.cell, from.cell + cells_of_side}) {
    const auto first =
        std::lower_bound (directions.begin(),
                          directions.end(),
                          middle_cell - 1,
                          [] (const Direction& direction, std::uint32_t cell) {
                            return direction.cell < cell;
                          });
    for (auto other = first;
         other != directions.end() && other->cell <= middle_cell + 1;
         ++other) {
      if (other - first > max_in_three_cells)
        return std::nullopt;
      const float squared_distance = (other->unit - from.unit).squaredNorm();
      if (squared_distance > 0.0f)
        least_squared_distance = std::min (least_squared_distance, squared_distance);
    }
  }
  if (!std::isfinite (least_squared_distance))
    return std::nullopt;
  return std::sqrt (least_squared_distance);
}

/** \brief Successive steps in a sorted list. */
struct StepGroup {
  std::size_t first = 0; // index in the list
  std::size_t size = 0;
};

/** \brief Returns the largest group of steps that exceed the first one of the group by
 * 12 % at most.
 * \param[in] steps ascending angles [rad] */
StepGroup
commonestSteps (const std::vector<float>& steps)
{
  constexpr float max_ratio = 1.12f;
  StepGroup largest;
  std::size_t end = 0;
  for (std::size_t first = 0; first < steps.size(); ++first) {
    while (end < steps.size() && steps[end] <= max_ratio * steps[first])
      ++end;
    if (end - first > largest.size)
      largest = {first, end - first};
  }
  return largest;
}

} // namespace

double
shareOfCommonSteps (const Coordinates& points, const Eigen::Vector3d& position)
{
  constexpr std::size_t max_sampled = 4000; // limits the time
  constexpr std::size_t min_steps = 100;
  const std::vector<Direction> directions = directionsOf (points, position);
  const std::size_t stride = directions.size() / max_sampled + 1;
  std::vector<float> steps;
  for (std::size_t i = 0; i < directions.size(); i += stride)
    if (const std::optional<float> step = stepAt (directions, directions[i]))
      steps.push_back (*step);
  const std::size_t sampled = (directions.size() + stride - 1) / stride;
  if (steps.size() < std::max (min_steps, sampled / 2))
    return 0.0;
  const auto all_steps = static_cast<double> (steps.size());
  std::sort (steps.begin(), steps.end());
  const StepGroup commonest = commonestSteps (steps);
  const auto begin = steps.begin() + static_cast<std::ptrdiff_t> (commonest.first);
  // Without them the second commonest steps are the commonest ones of the rest.
  steps.erase (begin, begin + static_cast<std::ptrdiff_t> (commonest.size));
  const StepGroup second_commonest = commonestSteps (steps);
  return static_cast<double> (commonest.size + second_commonest.size) / all_steps;
}

StepsSay
seenByItsSteps (const Coordinates& points, const Eigen::Vector3d& position)
{
  // At the sensor 13 of 15 lidar scans have a share of .7 to 1. The other two, whose
  // scan lines cross, have a smaller share at all six positions nearby than at the
  // sensor. From elsewhere the share is larger at a position nearer to the sensor.
  constexpr double sure_share = 0.7;
  constexpr double min_share = 0.17; // a smaller share tells nothing
  // Limits of the largest share nearby over the share here.
  constexpr double max_ratio_at_sensor = 0.85;
  constexpr double min_ratio_elsewhere = 1.06;
  // How far away the positions nearby are, in units of the median range of the points.
  constexpr double ranges_to_nearby = 0.15;
  const double share = shareOfCommonSteps (points, position);
  if (share >= sure_share)
    return StepsSay::Yes;
  if (share < min_share)
    return StepsSay::CannotTell;
  std::vector<float> ranges;
  for (std::size_t i = 0; i < points.size(); ++i)
    ranges.push_back (static_cast<float> ((points[i] - position).norm()));
  const double distance = ranges_to_nearby * medianOf (ranges);
  double largest_share_nearby = 0.0;
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {-1.0, 1.0}) {
      const Vector3d nearby = position + sign * distance * Vector3d::Unit (axis);
      largest_share_nearby =
          std::max (largest_share_nearby, shareOfCommonSteps (points, nearby));
    }
  if (largest_share_nearby < max_ratio_at_sensor * share)
    return StepsSay::Yes;
  return largest_share_nearby > min_ratio_elsewhere * share ? StepsSay::No
                                                            : StepsSay::CannotTell;
}

} // namespace pcl_ops::internal
