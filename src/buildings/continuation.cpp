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
 * inside. The outline may run clockwise or counter-clockwise. */
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
    const double cross_product = along.x() * off.y() - along.y() * off.x();
    is_left_of_all = is_left_of_all && cross_product >= 0.0;
    is_right_of_all = is_right_of_all && cross_product <= 0.0;
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

/** \brief A position on an outline, and the length of the outline around it for which
 * it stands [m]. */
struct OutlineSample {
  Vector3d position;
  double length;
};

/** \brief Sums of these lengths that differ by less are equal [m], and so are numbers
 * of steps. Chosen by hand. */
constexpr double rounding_of_sums = 1e-6;

/** \brief Returns samples of an outline, in even steps on each side, so that they are
 * the same whichever corner comes first. */
std::vector<OutlineSample>
samplesAlong (const std::vector<Vector3d>& hull)
{
  double length = 0.0;
  for (std::size_t i = 0; i < hull.size(); ++i)
    length += (hull[(i + 1) % hull.size()] - hull[i]).norm();
  const double step = length / static_cast<double> (constants.samples_of_outline);
  std::vector<OutlineSample> samples;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vector3d side = hull[(i + 1) % hull.size()] - hull[i];
    const double side_length = side.norm();
    const int steps = std::max (
        1, static_cast<int> (std::lround (side_length / step - rounding_of_sums)));
    for (int j = 0; j < steps; ++j)
      samples.push_back ({hull[i] + (j + 0.5) / steps * side, side_length / steps});
  }
  return samples;
}

/** \brief Returns z of the plane at x and y of a position [m]. */
double
heightAt (const PlaneFromAbove& plane, const Vector3d& position)
{
  const Vector2d off = (position - plane.center).head<2>();
  return plane.center.z() - plane.normal.head<2>().dot (off) / plane.normal.z();
}

/** \brief Returns whether a plane is higher than a position beside it by headroom or
 * more, both above the position and at the center of the plane. The other half of a
 * gable roof is not higher than its ridge. */
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
  // Lengths of the outline: like a roof, and like the ground for either reason [m].
  double over_drops = 0.0;
  double continued = 0.0;
  double below_slopes = 0.0;
  for (const auto& [position, length] : samplesAlong (plane.hull)) {
    bool is_over_drop = false;
    bool is_continued = false;
    bool is_below_slope = false;
    for (const PlaneFromAbove& other : neighbors) {
      if (distanceToOutline (other.hull, position.head<2>()) >
          constants.max_beside_outline)
        continue;
      const double drop = position.z() - heightAt (other, position);
      is_over_drop = is_over_drop || drop >= constants.headroom;
      is_continued = is_continued || (std::abs (drop) < constants.same_height &&
                                      plane.normal.dot (other.normal) >
                                          constants.min_cosine_of_same_slope);
      is_below_slope = is_below_slope || risesAbove (position, other);
    }
    over_drops += is_over_drop ? length : 0.0;
    continued += is_continued && !is_over_drop ? length : 0.0;
    below_slopes += is_below_slope && !is_over_drop ? length : 0.0;
  }
  return 2.0 * (continued + below_slopes) > over_drops + rounding_of_sums;
}

bool
isLowest (const PlaneFromAbove& plane,
          const std::vector<PlaneFromAbove>& all,
          double min_drop)
{
  const std::vector<PlaneFromAbove> neighbors = neighborsOf (plane, all);
  const auto is_over_other = [&] (const Vector3d& sample) {
    // Halfway to the center: near its outline a plane may overhang others.
    const Vector3d position = 0.5 * (plane.center + sample);
    return std::any_of (
        neighbors.begin(), neighbors.end(), [&] (const PlaneFromAbove& other) {
          return distanceToOutline (other.hull, position.head<2>()) == 0.0 &&
                 position.z() - heightAt (other, position) >= min_drop;
        });
  };
  // Lengths of the outline [m].
  double whole = 0.0;
  double over_others = 0.0;
  for (const auto& [position, length] : samplesAlong (plane.hull)) {
    whole += length;
    over_others += is_over_other (position) ? length : 0.0;
  }
  return 2.0 * over_others < whole - rounding_of_sums;
}

} // namespace pcl_ops::internal::buildings
