// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scenes.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace pcl_ops::simulation {

namespace {

// Lengths and heights are in meters. Their ranges are those of common houses and cars.

/** Adds the side walls and, in 60 % of the houses, the slope of the roof on the side of
 * the street, which hides the other slope. The side walls begin at the height of the
 * foot of the facade; the ground, which rises behind it, hides their lower ends.
 * \param[in] width of the facade
 * \param[in] eaves height of the facade */
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
  const double overhang = random.between (0.2, 0.5);
  house.addFace ({0, overhang, eaves - overhang * slope},
                 {0, -half_depth, eaves + half_depth * slope},
                 {width, 0, 0});
}

/** A window, a door or a garage door. */
struct Opening {
  double width, height;
  double sill;  // height of the lower edge above the floor
  double depth; // from the front of the wall to the window or the door
};

/** Draws a house whose facade looks to +y, with the middle of its foot at the origin.
 * Each story has the same number of bays. One bay of the ground floor has a door or
 * a garage door; all others have windows, which are alike.
 * \param[in] width of the facade */
Body
drawTownHouse (double width, Random& random)
{
  const int stories = 1 + int (random.below (4));
  const int bays = int (width / random.between (2.8, 3.4));
  const double story_height = random.between (2.7, 3.2);
  const double bay_width = width / bays;
  // Braces fix the order of evaluation, and so which random number is which.
  const Opening window{random.between (0.9, 1.6),    // width
                       random.between (1.2, 1.6),    // height
                       random.between (0.7, 1.0),    // sill
                       random.between (0.10, 0.20)}; // depth
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
      const Opening& opening = story == 0 && bay == bay_of_door ? door : window;
      const double floor = story * story_height;
      const double bottom = floor + opening.sill;
      const double top = story + 1 == stories ? eaves : (story + 1) * story_height;
      const double left = bay * bay_width - 0.5 * width;
      const double middle = ((bay + 0.5) / bays - 0.5) * width;
      house.addWallAround ({left, left + bay_width, floor, top},
                           {middle - 0.5 * opening.width,
                            middle + 0.5 * opening.width,
                            bottom,
                            bottom + opening.height},
                           opening.depth);
    }
  addSidesAndRoof (house, width, eaves, random);
  house.joinCoplanar();
  return house;
}

/** Draws a car along x on round wheels. It has no surface in the triangles beside its
 * slanted windows. */
Body
drawCar (Random& random)
{
  const double length = random.between (3.8, 4.8);
  const double width = random.between (1.65, 1.85);
  const double sill = random.between (0.2, 0.3);
  const double belt = random.between (0.8, 1.05); // lower edge of the windows
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
    car.addSurface (
        WallRange{rear, front, belt, roof}.rectangleAt (side * cabin_width));
  constexpr double radius = 0.31;       // of a wheel
  constexpr double half_wheel = 0.1;    // half the width of a tire
  constexpr double wheel_inside = 0.05; // from the side of the car inwards to a tire
  // A hub is a cap of a ball with the radius of the wheel. The center of the ball lies
  // this far inside the side of the car, so that the cap bulges out by 6 cm.
  constexpr double hub_inside = 0.25;
  for (const double along : {-0.3, 0.3})
    for (const double side : {-1.0, 1.0}) {
      const double x = along * length;
      const double y = side * (0.5 * width - wheel_inside - half_wheel);
      car.addCylinder ({x, y, radius}, Vector3d::UnitY(), half_wheel, radius);
      car.addSphere ({x, side * (0.5 * width - hub_inside), radius}, radius);
    }
  return car;
}

/** Adds leaves, which are small balls, evenly spread over the part of a large ball that
 * is above a lowest height.
 * \param[in] middle of the large ball
 * \param[in] crown radius of the large ball
 * \param[in] lowest height */
void
addLeaves (
    Body& plant, const Vector3d& middle, double crown, double lowest, Random& random)
{
  constexpr double smallest_leaf = 0.03; // radius
  constexpr double largest_leaf = 0.08;  // radius
  // With this number about a fifth of the rays through the middle pass between the
  // leaves; half of the drawn positions are outside the ball and get no leaf.
  const double crown_in_leaves = crown / largest_leaf;
  const auto leaves = int (4.0 * crown_in_leaves * crown_in_leaves);
  for (int i = 0; i < leaves; ++i) {
    const Vector3d from_middle = random.inBox ({-1, -1, -1}, {1, 1, 1}); // in crowns
    const double radius = random.between (smallest_leaf, largest_leaf);
    const Vector3d center = middle + crown * from_middle;
    if (from_middle.norm() <= 1.0 && center.z() > lowest)
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
  double length;   // of the street
  double curb;     // height of the curb
  double sidewalk; // width, from the curb to the gardens
  double slope;    // tangent of the angle at which the ground rises behind the curb

  /** Returns a pose on the ground behind the curb: y <= 0. */
  Isometry3d
  poseOnGround (double x, double y) const
  {
    return pose * at ({x, y, curb - slope * y});
  }
};

/** Adds up to three bushes to the garden in front of a house, each if the garden is
 * deep enough for it; it may reach over the garden's border.
 * \param[in] middle position of the center of the house along the street [m]
 * \param[in] setback depth of the garden */
void
addBushes (
    Scene& scene, const Roadside& side, double middle, double setback, Random& random)
{
  const auto bushes = int (random.below (4));
  for (int i = 0; i < bushes; ++i) {
    const double radius = random.between (0.3, 0.6);
    const double x = middle + random.between (-4, 4);
    const double y = -side.sidewalk - random.between (0, setback);
    if (!(setback > 2.0 * radius))
      continue;
    Body bush;
    addLeaves (bush, {0, 0, 0.5 * radius}, radius, 0.0, random);
    scene.add (bush, side.poseOnGround (x, y));
  }
}

/** Adds a row of houses along the side, and the bushes in their gardens. */
void
addHouses (Scene& scene, const Roadside& side, Random& random)
{
  constexpr double narrowest = 9.0;
  constexpr double widest = 15.0;
  // Distance from the gardens' front to a facade is a multiple of this, and up to 0.04
  // more. Each multiple is used once, so that no two facades are coplanar.
  constexpr double setback_step = 0.4;
  std::vector<int> multiples (std::size_t (side.length / narrowest));
  std::iota (multiples.begin(), multiples.end(), 0);
  for (std::size_t i = multiples.size() - 1; i > 0; --i) // Fisher & Yates shuffle
    std::swap (multiples[i], multiples[random.below (std::uint32_t (i + 1))]);
  double x = -0.5 * side.length;
  for (const int multiple : multiples) {
    const double width = random.between (narrowest, widest);
    if (x + width > 0.5 * side.length)
      break;
    const double setback = setback_step * multiple + random.between (0.0, 0.04);
    const double middle = x + 0.5 * width;
    scene.add (drawTownHouse (width, random),
               side.poseOnGround (middle, -side.sidewalk - setback));
    addBushes (scene, side, middle, setback, random);
    const bool has_alley = random.chance (0.4);
    x += width + (has_alley ? random.between (1.5, 4) : 0.1);
  }
}

void
addParkedCars (Scene& scene, const Roadside& side, Random& random)
{
  constexpr double parking_length = 6.5; // per car
  const double half_length = 0.5 * side.length;
  for (double middle = 0.5 * parking_length - half_length; middle < half_length;
       middle += parking_length)
    if (random.chance (0.45)) {
      const double x = middle + random.between (-0.5, 0.5);
      const double half_turns = random.chance (0.5) ? 1.0 : 0.0;
      const double yaw = random.angle (-2, 2) + half_turns * pi;
      const Isometry3d pose = side.pose * at ({x, random.between (1.0, 1.5), 0});
      scene.add (drawCar (random), pose * turnZ (yaw));
    }
}

void
addTreesAndPoles (Scene& scene, const Roadside& side, Random& random)
{
  constexpr double distance_of_trees = 9.0; // along the street
  constexpr double y_of_trees = -0.6;
  const double half_length = 0.5 * side.length;
  for (double x = 2.0 - half_length; x < half_length; x += distance_of_trees) {
    const Isometry3d pose = side.poseOnGround (x + random.between (-1, 1), y_of_trees);
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

/** Adds one side of the street: curb, ground, houses, parked cars, trees and poles.
 * \param[in] pose of the street, turned so that this side is at y < 0 */
void
addSide (Site& street, const Isometry3d& pose, Random& random)
{
  const Roadside side{pose * at ({0, -0.5 * street.size.y(), 0}),
                      street.size.x(),              // length
                      random.between (0.10, 0.15),  // curb
                      random.between (2.5, 4.0),    // sidewalk
                      random.between (0.02, 0.03)}; // slope
  constexpr double depth = 25.0; // of the ground, from the curb to behind the houses
  Body ground;
  const Vector3d curb (0, 0, side.curb);
  const Vector3d along (side.length, 0, 0);
  ground.addFace ({0, 0, 0}, curb, along);
  ground.addFace (curb, curb + Vector3d (0, -depth, side.slope * depth), along);
  street.scene.add (ground, side.pose);
  addHouses (street.scene, side, random);
  addParkedCars (street.scene, side, random);
  addTreesAndPoles (street.scene, side, random);
}

/** Returns a pose on the road, in the middle of the right lane.
 * \param[in] x along the street, 0 in its middle */
Isometry3d
poseOnLane (const Site& street, double x)
{
  // From the middle of the road: parked cars take some 2.4 m of the lane at the curb.
  constexpr double share_of_width = 0.15;
  return turnZ (street.yaw) * at ({x, -share_of_width * street.size.y(), 0});
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
  return poseOnLane (street, x) * at ({0, y, height}) * turnZ (yaw) * turnY (pitch) *
         turnX (roll);
}

Poses
drawDrive (const Site& street, std::size_t frames, Seed seed)
{
  constexpr double longest_step = 1.0;
  constexpr double sway = 0.2;              // amplitude of the shift to both sides
  constexpr double wave_length = 25.0;      // of the sway along the street
  constexpr double tilt = 0.7 * pi / 180.0; // amplitude of pitch and roll [rad]
  Random random = randomFor (Purpose::Drive, seed);
  const double phase = random.between (0.0, 2.0 * pi);
  const double height = random.between (1.7, 1.9);
  const double steps = double (std::max<std::size_t> (frames, 2) - 1);
  const double length = std::min (0.5 * street.size.x(), longest_step * steps);
  Poses poses;
  for (std::size_t i = 0; i < frames; ++i) {
    const double x = (double (i) / steps - 0.5) * length;
    const double angle = phase + 2.0 * pi * x / wave_length; // phase of the sway [rad]
    const double yaw = 2.0 * pi / wave_length * sway * std::cos (angle);
    poses.push_back (poseOnLane (street, x) *
                     at ({0, sway * std::sin (angle), height}) * turnZ (yaw) *
                     // The factors keep pitch and roll out of step with the sway.
                     turnY (tilt * std::sin (1.7 * angle)) *
                     turnX (tilt * std::sin (1.3 * angle)));
  }
  return poses;
}

} // namespace pcl_ops::simulation
