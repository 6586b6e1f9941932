// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scenes.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace pcl_ops::simulation {

namespace {

/** Adds the side walls, whose part below z = 0 the ground hides, and often the roof
 * slope towards the street. That slope hides the other one. */
void
addSidesAndRoof (Body& house, double width, double eaves, Random& random)
{
  const double half_depth = 0.5 * random.between (8, 12);
  for (const double side : {-0.5, 0.5})
    house.addFace ({side * width, -half_depth, 0},
                   {side * width, -half_depth, eaves},
                   {0, 2.0 * half_depth, 0});
  if (!random.chance (0.6))
    return;
  const double slope = std::tan (random.angle (30, 45));
  const double overhang = random.between (0.2, 0.5); // [m]
  house.addFace ({0, overhang, eaves - overhang * slope},
                 {0, -half_depth, eaves + half_depth * slope},
                 {width, 0, 0});
}

/** [m] */
struct Opening {
  double width, height, sill, depth;
};

/** Draws a house whose facade looks to +y, with the middle of its foot at the origin.
 * All windows are equally deep.
 * \param[in] width of the facade [m] */
Body
drawTownHouse (double width, Random& random)
{
  const int stories = 1 + int (random.below (4));
  const int bays = int (width / random.between (2.8, 3.4));
  const double story_height = random.between (2.7, 3.2);
  const double bay_width = width / bays;
  // An initializer list is evaluated from left to right.
  const Opening window{random.between (0.9, 1.6),
                       random.between (1.2, 1.6),
                       random.between (0.7, 1.0),
                       random.between (0.10, 0.20)};
  const bool is_garage = random.chance (0.4);
  const Opening door{is_garage ? 2.4 : random.between (1.0, 1.4),
                     random.between (2.1, 2.4),
                     0.06,
                     random.between (0.28, 0.40)};
  const int bay_of_door = int (random.below (std::uint32_t (bays)));
  const double eaves = stories * story_height + random.between (0.2, 0.6);
  Body house;
  for (int story = 0; story < stories; ++story)
    for (int bay = 0; bay < bays; ++bay) {
      const auto& [hole, height, sill, depth] =
          story == 0 && bay == bay_of_door ? door : window;
      const double floor = story * story_height;
      const double bottom = floor + sill;
      const double top = story + 1 == stories ? eaves : (story + 1) * story_height;
      const double left = bay * bay_width - 0.5 * width;
      const double middle = ((bay + 0.5) / bays - 0.5) * width;
      house.addWallAround (
          {left, left + bay_width, floor, top},
          {middle - 0.5 * hole, middle + 0.5 * hole, bottom, bottom + height},
          depth);
    }
  addSidesAndRoof (house, width, eaves, random);
  house.joinCoplanar();
  return house;
}

/** Draws a car along x on round wheels. The triangles beside its slanted windows are
 * open. */
Body
drawCar (Random& random)
{
  const double length = random.between (3.8, 4.8);
  const double width = random.between (1.65, 1.85);
  const double sill = random.between (0.2, 0.3);
  const double belt = random.between (0.8, 1.05);
  const double roof = belt + random.between (0.5, 0.8);
  Body car;
  car.addBox (at ({0, 0, 0.5 * (sill + belt)}),
              {length, width, belt - sill},
              HiddenFace::Bottom);
  // Slanted windows in front and behind, upright ones beside, a roof on top.
  const double front_foot = random.between (0.2, 0.3) * length;
  const double front = random.between (0.0, 0.1) * length;
  const double rear = random.between (-0.45, -0.3) * length;
  const double rear_foot = -0.48 * length;
  const double cabin_width = width - 0.24;
  const Vector3d across (0, cabin_width, 0);
  car.addFace ({front_foot, 0, belt}, {front, 0, roof}, across);
  car.addFace ({rear, 0, roof}, {front, 0, roof}, across);
  car.addFace ({rear_foot, 0, belt}, {rear, 0, roof}, across);
  for (const double side : {-0.5, 0.5})
    car.addSurface (WallRange{rear, front, belt, roof}.at (side * cabin_width));
  constexpr double radius = 0.31;
  constexpr double half_wheel = 0.1;
  // So that the cap of a hub bulges out of the side.
  constexpr double hub_inside = 0.25;
  for (const double along : {-0.3, 0.3})
    for (const double side : {-1.0, 1.0}) {
      const double x = along * length;
      const double y = side * (0.5 * width - 0.05 - half_wheel);
      car.addCylinder ({x, y, radius}, Vector3d::UnitY(), half_wheel, radius);
      car.addSphere ({x, side * (0.5 * width - hub_inside), radius}, radius);
    }
  return car;
}

/** Adds leaves (small balls), evenly distributed in a ball above a lowest height.
 * \param[in] crown radius of the ball [m] */
void
addLeaves (
    Body& plant, const Vector3d& middle, double crown, double lowest, Random& random)
{
  constexpr double leaf = 0.03;
  constexpr double largest_leaf = 0.08; // radii [m]
  // With this number about a quarter of the rays through the middle pass between the
  // leaves; half of the drawn places are outside the ball and get no leaf.
  const double radii = crown / largest_leaf;
  const auto leaves = int (4.0 * radii * radii);
  for (int i = 0; i < leaves; ++i) {
    const Vector3d place = random.inBox ({-1, -1, -1}, {1, 1, 1});
    const double radius = random.between (leaf, largest_leaf);
    const Vector3d center = middle + crown * place;
    if (place.norm() <= 1.0 && center.z() > lowest)
      plant.addSphere (center, radius);
  }
}

/** A trunk and a crown of leaves. */
Body
drawTree (Random& random)
{
  Body tree;
  const double trunk = random.between (1.6, 2.6);
  const double radius = random.between (1.0, 2.0);
  tree.addPole ({0, 0, 0}, trunk + 0.5 * radius, random.between (0.08, 0.25));
  addLeaves (tree, {0, 0, trunk + 0.9 * radius}, radius, trunk, random);
  return tree;
}

/** One side of a street. Its frame has x along the street, y towards the road, y = 0 at
 * the curb, and z up from the road. */
struct Roadside {
  Isometry3d pose;
  double length, curb; // of the street, and height of the curb [m]
  double sidewalk;     // from the curb to the gardens [m]
  double slope;        // rise of the ground from the curb on, per length

  Isometry3d
  onGround (double x, double y) const
  {
    return pose * at ({x, y, curb - slope * y});
  }
};

void
addBushes (Scene& scene, const Roadside& side, double x, double setback, Random& random)
{
  const auto bushes = int (random.below (4));
  for (int i = 0; i < bushes; ++i) {
    const double radius = random.between (0.3, 0.6);
    const double place = x + random.between (-4, 4);
    const double y = -side.sidewalk - random.between (0, setback);
    if (!(setback > 2.0 * radius))
      continue;
    Body bush;
    addLeaves (bush, {0, 0, 0.5 * radius}, radius, 0.0, random);
    scene.add (bush, side.onGround (place, y));
  }
}

void
addHouses (Scene& scene, const Roadside& side, Random& random)
{
  constexpr double narrow = 9.0;
  constexpr double wide = 15.0; // [m]
  // Offset between facades, so that no two are coplanar [m].
  constexpr double setback_step = 0.4;
  std::vector<int> rows (std::size_t (side.length / narrow));
  std::iota (rows.begin(), rows.end(), 0);
  for (std::size_t i = rows.size() - 1; i > 0; --i) // Fisher & Yates
    std::swap (rows[i], rows[random.below (std::uint32_t (i + 1))]);
  double x = -0.5 * side.length;
  for (const int row : rows) {
    const double width = random.between (narrow, wide);
    if (x + width > 0.5 * side.length)
      break;
    const double setback = setback_step * row + random.between (0.0, 0.04);
    const double middle = x + 0.5 * width;
    scene.add (drawTownHouse (width, random),
               side.onGround (middle, -side.sidewalk - setback));
    addBushes (scene, side, middle, setback, random);
    const bool has_alley = random.chance (0.4);
    x += width + (has_alley ? random.between (1.5, 4) : 0.1);
  }
}

void
addRows (Scene& scene, const Roadside& side, Random& random)
{
  constexpr double spot = 6.5;
  constexpr double gap_of_trees = 9.0; // [m]
  const double half_length = 0.5 * side.length;
  for (double x = 0.5 * spot - half_length; x < half_length; x += spot)
    if (random.chance (0.45)) {
      const double place = x + random.between (-0.5, 0.5);
      const double half_turns = random.chance (0.5) ? 1.0 : 0.0;
      const double yaw = random.angle (-2, 2) + half_turns * pi;
      const Isometry3d pose = side.pose * at ({place, random.between (1.0, 1.5), 0});
      scene.add (drawCar (random), pose * turnZ (yaw));
    }
  for (double x = 2.0 - half_length; x < half_length; x += gap_of_trees) {
    const Isometry3d pose = side.onGround (x + random.between (-1, 1), -0.6);
    if (random.chance (0.5))
      scene.add (drawTree (random), pose);
    else if (random.chance (0.6)) { // a lamp or a sign
      Body pole;
      const double height = random.between (2.5, 8);
      pole.addPole ({0, 0, 0}, height, random.between (0.03, 0.1));
      scene.add (pole, pose);
    }
  }
}

void
addSide (Site& street, const Isometry3d& pose, Random& random)
{
  const Roadside side{pose * at ({0, -0.5 * street.size.y(), 0}),
                      street.size.x(),
                      random.between (0.10, 0.15),
                      random.between (2.5, 4.0),
                      random.between (0.02, 0.03)};
  constexpr double depth = 25.0; // of the ground, to behind the houses [m]
  Body ground;
  const Vector3d curb (0, 0, side.curb);
  const Vector3d along (side.length, 0, 0);
  ground.addFace ({0, 0, 0}, curb, along);
  ground.addFace (curb, curb + Vector3d (0, -depth, side.slope * depth), along);
  street.scene.add (ground, side.pose);
  addHouses (street.scene, side, random);
  addRows (street.scene, side, random);
}

Isometry3d
onLane (const Site& street, double x)
{
  return turnZ (street.yaw) * at ({x, -0.15 * street.size.y(), 0});
}

} // namespace

Site
makeStreet (Seed seed)
{
  Random random = randomFor (Purpose::Street, seed);
  Site street;
  street.size.x() = random.between (120, 160);
  street.size.y() = random.between (10, 12);
  street.yaw = random.angle (0, 360);
  const Isometry3d pose = turnZ (street.yaw);
  Body road;
  road.addSurface (
      makeRectangle ({0, 0, 0}, {street.size.x(), 0, 0}, {0, street.size.y(), 0}));
  street.scene.add (road, pose);
  for (const double half_turns : {0.0, 1.0})
    addSide (street, pose * turnZ (half_turns * pi), random);
  return street;
}

Isometry3d
drawSensorPose (const Site& street, Seed seed)
{
  Random random = randomFor (Purpose::SensorPose, seed);
  const double x = random.between (-20, 20);
  const double y = random.between (-0.3, 0.3);
  const double height = random.between (1.7, 1.9);
  const double yaw = random.angle (-3, 3);
  const double pitch = random.angle (-1, 1);
  const double roll = random.angle (-1, 1);
  return onLane (street, x) * at ({0, y, height}) * turnZ (yaw) * turnY (pitch) *
         turnX (roll);
}

Poses
drawDrive (const Site& street, std::size_t frames, Seed seed)
{
  constexpr double longest_step = 1.0; // [m]
  constexpr double sway = 0.2;         // [m]
  constexpr double wave = 25.0;        // of the sway [m]
  constexpr double tilt = 0.7 * pi / 180.0;
  Random random = randomFor (Purpose::Drive, seed);
  const double phase = random.between (0.0, 2.0 * pi);
  const double height = random.between (1.7, 1.9);
  const double steps = double (std::max<std::size_t> (frames, 2) - 1);
  const double way = std::min (0.5 * street.size.x(), longest_step * steps);
  Poses poses;
  for (std::size_t i = 0; i < frames; ++i) {
    const double x = (double (i) / steps - 0.5) * way;
    const double angle = phase + 2.0 * pi * x / wave;
    const double yaw = 2.0 * pi / wave * sway * std::cos (angle);
    poses.push_back (onLane (street, x) * at ({0, sway * std::sin (angle), height}) *
                     turnZ (yaw) * turnY (tilt * std::sin (1.7 * angle)) *
                     turnX (tilt * std::sin (1.3 * angle)));
  }
  return poses;
}

} // namespace pcl_ops::simulation
