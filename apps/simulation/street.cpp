// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "street.h"

#include "poses.h"
#include "street_things.h"

#include <algorithm>
#include <utility>

namespace pcl_ops::simulation {

namespace {

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
  Eigen::Isometry3d pose;
  double length;
  /** \brief Height of the curb, and of the sidewalk from the curb to the gardens [m].
   */
  double curb, sidewalk;
  /** \brief How the sidewalk rises from the curb on. */
  double slope;

  Eigen::Isometry3d
  onGround (double x, double y) const
  {
    return pose * at (x, y, curb - slope * y);
  }
};

Body
makeGround (const Roadside& side)
{
  Body ground;
  addSurface (ground,
              {{0.0, 0.0, 0.5 * side.curb},
               Vector3d::UnitX(),
               Vector3d::UnitZ(),
               0.5 * side.length,
               0.5 * side.curb});
  const Vector3d back (0.0, -depth_of_ground, side.slope * depth_of_ground);
  addSurface (ground,
              {side.curb * Vector3d::UnitZ() + 0.5 * back,
               Vector3d::UnitX(),
               back.normalized(),
               0.5 * side.length,
               0.5 * back.norm()});
  return ground;
}

/** \brief 0 .. count - 1 in some order (Fisher & Yates). */
std::vector<int>
drawOrder (int count, internal::RandomGenerator& generator)
{
  std::vector<int> order;
  for (int i = 0; i < count; ++i)
    order.push_back (i);
  for (int i = count - 1; i > 0; --i)
    std::swap (order[i], order[internal::drawBelow (generator, std::uint32_t (i + 1))]);
  return order;
}

void
addBushes (Scene& scene,
           const Roadside& side,
           double x,
           double setback,
           internal::RandomGenerator& generator)
{
  const auto bushes = int (internal::drawBelow (generator, 4));
  for (int i = 0; i < bushes; ++i) {
    const double radius = drawBetween (generator, 0.3, 0.6);
    const double place = x + drawBetween (generator, -4, 4);
    const double y = -side.sidewalk - drawBetween (generator, 0, setback);
    if (setback > 2.0 * radius)
      addBody (scene, makeBush (radius, generator), side.onGround (place, y));
  }
}

void
addHouses (Scene& scene, const Roadside& side, internal::RandomGenerator& generator)
{
  constexpr double narrow = 9.0, wide = 15.0; // [m]
  const std::vector<int> setbacks = drawOrder (int (side.length / narrow), generator);
  double x = -0.5 * side.length;
  for (std::size_t i = 0; i < setbacks.size(); ++i) {
    const double width = drawBetween (generator, narrow, wide);
    if (x + width > 0.5 * side.length)
      break;
    const double setback =
        setback_step * setbacks[i] + drawBetween (generator, 0.0, 0.04);
    const double middle = x + 0.5 * width;
    addBody (scene,
             makeTownHouse (width, generator),
             side.onGround (middle, -side.sidewalk - setback));
    addBushes (scene, side, middle, setback, generator);
    const bool has_alley = drawChance (generator, 0.4);
    x += width + (has_alley ? drawBetween (generator, 1.5, 4) : 0.1);
  }
}

/** \brief A car on the road beside the curb. */
void
addCar (Scene& scene,
        const Roadside& side,
        double x,
        internal::RandomGenerator& generator)
{
  const double half_turns = drawChance (generator, 0.5) ? 1.0 : 0.0;
  const double yaw = drawAngle (generator, -2, 2) + half_turns * pi;
  const double y = drawBetween (generator, 1.0, 1.5);
  addBody (scene,
           makeCar (generator),
           side.pose * at (x, y, 0.0) * turned (yaw, Vector3d::UnitZ()));
}

/** \brief Parked cars, and trees and poles on the edge of the sidewalk. */
void
addRows (Scene& scene, const Roadside& side, internal::RandomGenerator& generator)
{
  constexpr double spot = 6.5, gap_of_trees = 9.0; // [m]
  const double half_length = 0.5 * side.length;
  for (double x = 0.5 * spot - half_length; x < half_length; x += spot)
    if (drawChance (generator, 0.45))
      addCar (scene, side, x + drawBetween (generator, -0.5, 0.5), generator);
  for (double x = 2.0 - half_length; x < half_length; x += gap_of_trees) {
    const double place = x + drawBetween (generator, -1, 1);
    const Eigen::Isometry3d pose = side.onGround (place, -0.6);
    if (drawChance (generator, 0.5))
      addBody (scene, makeTree (generator), pose);
    else if (drawChance (generator, 0.6))
      addBody (scene, makePole (generator), pose);
  }
}

void
addSide (Scene& scene,
         const Street& street,
         const Eigen::Isometry3d& pose,
         internal::RandomGenerator& generator)
{
  Roadside side{};
  side.pose = pose * at (0.0, -0.5 * street.width, 0.0);
  side.length = street.length;
  side.curb = drawBetween (generator, 0.10, 0.15);
  side.sidewalk = drawBetween (generator, 2.5, 4.0);
  side.slope = drawBetween (generator, 0.02, 0.03);
  addBody (scene, makeGround (side), side.pose);
  addHouses (scene, side, generator);
  addRows (scene, side, generator);
}

/** \brief A place on the right lane. */
Eigen::Isometry3d
onLane (const Street& street, double x)
{
  return turned (street.yaw, Vector3d::UnitZ()) * at (x, -0.15 * street.width, 0.0);
}

} // namespace

Street
makeStreet (std::uint32_t seed)
{
  internal::RandomGenerator generator = makeGenerator (seed, Purpose::Street);
  Street street;
  street.length = drawBetween (generator, 120, 160);
  street.width = drawBetween (generator, 10, 12);
  street.yaw = drawAngle (generator, 0, 360);
  const Eigen::Isometry3d pose = turned (street.yaw, Vector3d::UnitZ());
  Scene scene;
  Body road;
  Rectangle asphalt;
  asphalt.half_u = 0.5 * street.length;
  asphalt.half_v = 0.5 * street.width;
  addSurface (road, asphalt);
  addBody (scene, road, pose);
  for (const double half_turns : {0.0, 1.0})
    addSide (
        scene, street, pose * turned (half_turns * pi, Vector3d::UnitZ()), generator);
  street.scene = divided (scene, edge_of_part);
  return street;
}

Eigen::Isometry3d
drawSensorPose (const Street& street, std::uint32_t seed)
{
  internal::RandomGenerator generator = makeGenerator (seed, Purpose::SensorPose);
  const double x = drawBetween (generator, -20, 20);
  const double y = drawBetween (generator, -0.3, 0.3);
  const double height = drawBetween (generator, 1.7, 1.9);
  const double yaw = drawAngle (generator, -3, 3);
  const double pitch = drawAngle (generator, -1, 1);
  const double roll = drawAngle (generator, -1, 1);
  return onLane (street, x) * at (0.0, y, height) * turned (yaw, Vector3d::UnitZ()) *
         turned (pitch, Vector3d::UnitY()) * turned (roll, Vector3d::UnitX());
}

Poses
drawDrive (const Street& street, std::size_t frames, std::uint32_t seed)
{
  constexpr double longest_step = 1.0; // [m]
  constexpr double sway = 0.2;         // [m]
  constexpr double wave = 25.0;        // of the sway [m]
  constexpr double tilt = 0.7 * pi / 180.0;
  internal::RandomGenerator generator = makeGenerator (seed, Purpose::Drive);
  const double phase = drawBetween (generator, 0.0, 2.0 * pi);
  const double height = drawBetween (generator, 1.7, 1.9);
  const double steps = double (std::max<std::size_t> (frames, 2) - 1);
  const double way = std::min (0.5 * street.length, longest_step * steps);
  Poses poses;
  for (std::size_t i = 0; i < frames; ++i) {
    const double x = (double (i) / steps - 0.5) * way;
    const double angle = phase + 2.0 * pi * x / wave;
    const double yaw = 2.0 * pi / wave * sway * std::cos (angle);
    poses.push_back (onLane (street, x) * at (0.0, sway * std::sin (angle), height) *
                     turned (yaw, Vector3d::UnitZ()) *
                     turned (tilt * std::sin (1.7 * angle), Vector3d::UnitY()) *
                     turned (tilt * std::sin (1.3 * angle), Vector3d::UnitX()));
  }
  return poses;
}

} // namespace pcl_ops::simulation
