// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "street.h"

#include "street_things.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace pcl_ops::simulation {

namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

/** \brief Of the parts that a scene is divided into for its rays [m]. */
constexpr double edge_of_part = 3.0;

/** \brief Facades of a side are so far behind each other: no two are in one plane [m].
 */
constexpr double setback_step = 0.4;
/** \brief From the curb to the end of the ground behind the houses [m]. */
constexpr double depth_of_ground = 25.0;

/** \brief One side of the street, in a frame of its own: x along it, y towards the
 * road, y = 0 the curb, z up from the road. */
struct Roadside {
  Isometry3d pose;
  double length;
  /** \brief Height of the curb, and of the sidewalk from the curb to the gardens [m].
   */
  double curb, sidewalk;
  /** \brief How the sidewalk rises from the curb on. */
  double slope;

  Isometry3d
  onGround (double x, double y) const
  {
    return pose * at (x, y, curb - slope * y);
  }
};

Body
makeGround (const Roadside& side)
{
  Body ground;
  const double half_length = 0.5 * side.length, half_curb = 0.5 * side.curb;
  addSurface (ground, rectangleAlong (0, 2, {0, 0, half_curb}, half_length, half_curb));
  const Vector3d back (0.0, -depth_of_ground, side.slope * depth_of_ground);
  addSurface (ground,
              {Shape::Kind::Rectangle,
               side.curb * Vector3d::UnitZ() + 0.5 * back,
               Vector3d::UnitX(),
               back.normalized(),
               half_length,
               0.5 * back.norm()});
  return ground;
}

/** \brief 0 .. count - 1 in some order (Fisher & Yates). */
std::vector<int>
drawOrder (int count, Random& random)
{
  std::vector<int> order (static_cast<std::size_t> (count));
  std::iota (order.begin(), order.end(), 0);
  for (int i = count - 1; i > 0; --i)
    std::swap (order[i], order[random.below (std::uint32_t (i + 1))]);
  return order;
}

void
addBushes (Scene& scene, const Roadside& side, double x, double setback, Random& random)
{
  const auto bushes = int (random.below (4));
  for (int i = 0; i < bushes; ++i) {
    const double radius = random.between (0.3, 0.6);
    const double place = x + random.between (-4, 4);
    const double y = -side.sidewalk - random.between (0, setback);
    if (setback > 2.0 * radius)
      addBody (scene, drawBush (radius, random), side.onGround (place, y));
  }
}

void
addHouses (Scene& scene, const Roadside& side, Random& random)
{
  constexpr double narrow = 9.0, wide = 15.0; // [m]
  double x = -0.5 * side.length;
  for (const int row : drawOrder (int (side.length / narrow), random)) {
    const double width = random.between (narrow, wide);
    if (x + width > 0.5 * side.length)
      break;
    const double setback = setback_step * row + random.between (0.0, 0.04);
    const double middle = x + 0.5 * width;
    addBody (scene,
             drawTownHouse (width, random),
             side.onGround (middle, -side.sidewalk - setback));
    addBushes (scene, side, middle, setback, random);
    const bool has_alley = random.chance (0.4);
    x += width + (has_alley ? random.between (1.5, 4) : 0.1);
  }
}

/** \brief A car on the road beside the curb. */
void
addCar (Scene& scene, const Roadside& side, double x, Random& random)
{
  const double half_turns = random.chance (0.5) ? 1.0 : 0.0;
  const double yaw = random.angle (-2, 2) + half_turns * pi;
  const double y = random.between (1.0, 1.5);
  addBody (scene, drawCar (random), side.pose * at (x, y, 0.0) * turnZ (yaw));
}

/** \brief Parked cars, and trees and poles on the edge of the sidewalk. */
void
addRows (Scene& scene, const Roadside& side, Random& random)
{
  constexpr double spot = 6.5, gap_of_trees = 9.0; // [m]
  const double half_length = 0.5 * side.length;
  for (double x = 0.5 * spot - half_length; x < half_length; x += spot)
    if (random.chance (0.45))
      addCar (scene, side, x + random.between (-0.5, 0.5), random);
  for (double x = 2.0 - half_length; x < half_length; x += gap_of_trees) {
    const Isometry3d pose = side.onGround (x + random.between (-1, 1), -0.6);
    if (random.chance (0.5))
      addBody (scene, drawTree (random), pose);
    else if (random.chance (0.6))
      addBody (scene, drawPole (random), pose);
  }
}

void
addSide (Scene& scene, const Street& street, const Isometry3d& pose, Random& random)
{
  Roadside side{};
  side.pose = pose * at (0.0, -0.5 * street.width, 0.0);
  side.length = street.length;
  side.curb = random.between (0.10, 0.15);
  side.sidewalk = random.between (2.5, 4.0);
  side.slope = random.between (0.02, 0.03);
  addBody (scene, makeGround (side), side.pose);
  addHouses (scene, side, random);
  addRows (scene, side, random);
}

/** \brief A place on the right lane. */
Isometry3d
onLane (const Street& street, double x)
{
  return turnZ (street.yaw) * at (x, -0.15 * street.width, 0.0);
}

} // namespace

Street
makeStreet (std::uint32_t seed)
{
  Random random = randomFor (Purpose::Street, seed);
  Street street;
  street.length = random.between (120, 160);
  street.width = random.between (10, 12);
  street.yaw = random.angle (0, 360);
  const Isometry3d pose = turnZ (street.yaw);
  Scene scene;
  Body road;
  addSurface (
      road, rectangleAlong (0, 1, {0, 0, 0}, 0.5 * street.length, 0.5 * street.width));
  addBody (scene, road, pose);
  for (const double half_turns : {0.0, 1.0})
    addSide (scene, street, pose * turnZ (half_turns * pi), random);
  street.scene = divided (scene, edge_of_part);
  return street;
}

Isometry3d
drawSensorPose (const Street& street, std::uint32_t seed)
{
  Random random = randomFor (Purpose::SensorPose, seed);
  const double x = random.between (-20, 20);
  const double y = random.between (-0.3, 0.3);
  const double height = random.between (1.7, 1.9);
  const double yaw = random.angle (-3, 3);
  const double pitch = random.angle (-1, 1);
  const double roll = random.angle (-1, 1);
  return onLane (street, x) * at (0.0, y, height) * turnZ (yaw) * turnY (pitch) *
         turnX (roll);
}

Poses
drawDrive (const Street& street, std::size_t frames, std::uint32_t seed)
{
  constexpr double longest_step = 1.0; // [m]
  constexpr double sway = 0.2;         // [m]
  constexpr double wave = 25.0;        // of the sway [m]
  constexpr double tilt = 0.7 * pi / 180.0;
  Random random = randomFor (Purpose::Drive, seed);
  const double phase = random.between (0.0, 2.0 * pi);
  const double height = random.between (1.7, 1.9);
  const double steps = double (std::max<std::size_t> (frames, 2) - 1);
  const double way = std::min (0.5 * street.length, longest_step * steps);
  Poses poses;
  for (std::size_t i = 0; i < frames; ++i) {
    const double x = (double (i) / steps - 0.5) * way;
    const double angle = phase + 2.0 * pi * x / wave;
    const double yaw = 2.0 * pi / wave * sway * std::cos (angle);
    poses.push_back (onLane (street, x) * at (0.0, sway * std::sin (angle), height) *
                     turnZ (yaw) * turnY (tilt * std::sin (1.7 * angle)) *
                     turnX (tilt * std::sin (1.3 * angle)));
  }
  return poses;
}

} // namespace pcl_ops::simulation
