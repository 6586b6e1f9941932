// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "continuation.h"

#include "constants.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace pcl_ops::internal::buildings {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/** \brief Returns the horizontal distance of a position to a convex outline [m]; 0
 * inside. */
double
distanceToOutline (const std::vector<Vector3d>& hull, const Vector2d& position)
{
  double nearest = std::numeric_limits<double>::infinity();
  bool is_left_of_all = true;
  bool is_right_of_all = true;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vector2d from = hull[i].head<2>();
    const Vector2d along = hull[(i + 1) % hull.size()].head<2>() - from;
    const Vector2d off = position - from;
    const double side = along.x() * off.y() - along.y() * off.x();
    is_left_of_all = is_left_of_all && side >= 0.0;
    is_right_of_all = is_right_of_all && side <= 0.0;
    const double squared_length = along.squaredNorm();
    // The nearest point of the side, as a share of its length.
    const double share = squared_length > 0.0
                             ? std::clamp (along.dot (off) / squared_length, 0.0, 1.0)
                             : 0.0;
    nearest = std::min (nearest, (off - share * along).norm());
  }
  return is_left_of_all || is_right_of_all ? 0.0 : nearest;
}

/** \brief Returns the radius of the horizontal circle around the center of a plane that
 * contains its outline [m]. */
double
reachOf (const PlaneFromAbove& plane)
{
  double reach = 0.0;
  for (const Vector3d& corner : plane.hull)
    reach = std::max (reach, (corner - plane.center).head<2>().norm());
  return reach;
}

/** \brief Returns the planes with an outline, other than \p plane, that may be within
 * max_beside_outline of it. */
std::vector<PlaneFromAbove>
neighborsOf (const PlaneFromAbove& plane, const std::vector<PlaneFromAbove>& all)
{
  const double reach = reachOf (plane);
  std::vector<PlaneFromAbove> neighbors;
  for (const PlaneFromAbove& other : all)
    if (&other != &plane && other.area >= constants.min_area_beside_outline &&
        other.hull.size() > 2 &&
        (other.center - plane.center).head<2>().norm() <=
            reach + reachOf (other) + constants.max_beside_outline)
      neighbors.push_back (other);
  return neighbors;
}

/** \brief Returns positions along an outline, in even steps. */
std::vector<Vector3d>
samplesAlong (const std::vector<Vector3d>& hull)
{
  double length = 0.0;
  for (std::size_t i = 0; i < hull.size(); ++i)
    length += (hull[(i + 1) % hull.size()] - hull[i]).norm();
  std::vector<Vector3d> samples;
  const double step = length / static_cast<double> (constants.samples_of_outline);
  double next = 0.5 * step; // distance of the next sample from the corner
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vector3d side = hull[(i + 1) % hull.size()] - hull[i];
    const double end = side.norm();
    for (; next < end && samples.size() < constants.samples_of_outline; next += step)
      samples.push_back (hull[i] + next / end * side);
    next -= end;
  }
  return samples;
}

/** \brief Returns the height of a plane where it is above or below a position [m]. The
 * height is that of the frame, not the distance from the position. */
double
heightAt (const PlaneFromAbove& plane, const Vector3d& position)
{
  const Vector2d off = (position - plane.center).head<2>();
  return plane.center.z() - plane.normal.head<2>().dot (off) / plane.normal.z();
}

/** \brief Returns whether a plane is higher than a position beside it by headroom or
 * more, both there and at its center. The other side of a gable is not: it falls from
 * the ridge. */
bool
risesAbove (const Vector3d& position, const PlaneFromAbove& plane)
{
  return std::min (plane.center.z(), heightAt (plane, position)) - position.z() >=
         constants.headroom;
}

} // namespace

bool
isPartOfGround (const PlaneFromAbove& plane, const std::vector<PlaneFromAbove>& all)
{
  const std::vector<PlaneFromAbove> neighbors = neighborsOf (plane, all);
  // Numbers of samples: like a roof, and like the ground for either reason.
  int at_steps = 0;
  int flush = 0;
  int below = 0;
  for (const Vector3d& position : samplesAlong (plane.hull)) {
    bool is_at_step = false;
    bool is_flush = false;
    bool is_below = false;
    for (const PlaneFromAbove& other : neighbors) {
      if (distanceToOutline (other.hull, position.head<2>()) >
          constants.max_beside_outline)
        continue;
      const double drop = position.z() - heightAt (other, position);
      is_at_step = is_at_step || drop >= constants.headroom;
      is_flush = is_flush ||
                 (std::abs (drop) < constants.same_height &&
                  plane.normal.dot (other.normal) > constants.min_cosine_of_same_slope);
      is_below = is_below || risesAbove (position, other);
    }
    at_steps += is_at_step ? 1 : 0;
    flush += is_flush && !is_at_step ? 1 : 0;
    below += is_below && !is_at_step ? 1 : 0;
  }
  return 2 * (flush + below) > at_steps;
}

bool
isLowest (const PlaneFromAbove& plane,
          const std::vector<PlaneFromAbove>& all,
          double min_drop)
{
  const std::vector<PlaneFromAbove> neighbors = neighborsOf (plane, all);
  const std::vector<Vector3d> outline = samplesAlong (plane.hull);
  const auto is_above = [&] (const Vector3d& corner) {
    // Halfway to the center: near its outline a plane may overhang others.
    const Vector3d position = 0.5 * (plane.center + corner);
    return std::any_of (
        neighbors.begin(), neighbors.end(), [&] (const PlaneFromAbove& other) {
          return distanceToOutline (other.hull, position.head<2>()) == 0.0 &&
                 position.z() - heightAt (other, position) >= min_drop;
        });
  };
  const auto above = std::count_if (outline.begin(), outline.end(), is_above);
  return 2 * static_cast<std::size_t> (above) < outline.size();
}

} // namespace pcl_ops::internal::buildings
