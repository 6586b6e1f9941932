// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "hilly_street.h"

#include <algorithm>

namespace pcl_ops::simulation {

namespace {

constexpr double sensor_height = 2.0;   // [m]
constexpr double half_length = 110.0;   // of the street [m]
constexpr double nearest_reading = 2.0; // [m]
constexpr double no_hit = std::numeric_limits<double>::infinity();

/** Adds the front and one side of a house. They begin below the ground, so that a slope
 * leaves no gap.
 * \param[in] x where the front begins and the side is; the front ends at a larger x [m]
 * \param[in] side of the street: 1 at y > 0, -1 at y < 0 */
void
addHouse (HillyStreet& street, double x, double side, Random& random)
{
  constexpr double depth = 9.0; // [m]
  constexpr double above = 6.0; // from the ground to the top of the walls [m]
  constexpr double below = 1.0; // from the ground to the lower end of the walls [m]
  const double length = random.between (12, 20);
  const double y = side * random.between (11, 15);
  const double foot = street.groundHeight (x + 0.5 * length, y);
  const double middle = foot + 0.5 * (above - below);
  const Vector3d up (0, 0, above + below);
  Body house;
  house.addSurface (makeRectangle ({x + 0.5 * length, y, middle}, {length, 0, 0}, up));
  house.addSurface (
      makeRectangle ({x, y + 0.5 * side * depth, middle}, {0, depth, 0}, up));
  street.walls.add (house, Isometry3d::Identity());
}

/** Draws a bush on either side of the street, low over the ground. */
Bush
drawBush (const HillyStreet& street, Random& random)
{
  Bush bush;
  const double x = random.between (-half_length, half_length);
  const double side = random.chance (0.5) ? 1.0 : -1.0;
  const double y = side * random.between (6, 60);
  bush.radius = random.between (0.6, 3.0);
  bush.center = {x, y, street.groundHeight (x, y) + random.between (0.3, 4.0)};
  return bush;
}

/** Returns the distance at which a ray from the origin goes below the ground, from the
 * nearest reading on; infinity if it does not within the range of the lidar.
 * \param[in] ray of length 1 */
double
distanceToGround (const HillyStreet& street, const Vector3d& ray)
{
  // Each step is longer than the one before by the same factor, growth.
  constexpr int steps = 500;
  const double growth = std::pow (street.lidar.farthest / nearest_reading, 1.0 / steps);
  const auto heightAboveGround = [&] (double distance) {
    const Vector3d position = distance * ray;
    return position.z() - street.groundHeight (position.x(), position.y());
  };
  double distance = nearest_reading;
  double height = heightAboveGround (distance);
  for (int step = 0; step < steps; ++step) {
    const double next = growth * distance;
    const double next_height = heightAboveGround (next);
    const bool goes_below = height > 0.0 && next_height <= 0.0;
    if (goes_below) // the ground is taken for straight in a step
      return distance + (next - distance) * height / (height - next_height);
    distance = next;
    height = next_height;
  }
  return no_hit;
}

/** Returns a random distance inside the ball if the ray meets the ball and hits a leaf,
 * else infinity.
 * \param[in] ray of length 1 */
double
distanceToBush (const Bush& bush, const Vector3d& ray, Random& random)
{
  constexpr double chance_of_leaf = 0.6;
  // Distance to the point of the ray nearest to the center, and the square of half the
  // chord of the ball on the ray: r^2 + middle^2 - |center|^2.
  const double middle = ray.dot (bush.center);
  const double squared_half_chord =
      bush.radius * bush.radius + middle * middle - bush.center.squaredNorm();
  if (!(middle > 0.0 && squared_half_chord > 0.0))
    return no_hit;
  const double distance =
      middle + std::sqrt (squared_half_chord) * random.between (-1, 1);
  return random.chance (chance_of_leaf) ? distance : no_hit;
}

} // namespace

double
HillyStreet::groundHeight (double x, double y) const
{
  return relief.height (x, y) - relief.height (0, 0) - sensor_height;
}

HillyStreet
makeHillyStreet (Seed seed)
{
  constexpr double distance_of_houses = 26.0; // along the street [m]
  constexpr double chance_of_house = 0.65;
  Random random = randomFor (Purpose::HillyStreet, seed);
  HillyStreet street;
  const double amplitude = random.between (0.5, 2);    // [m]
  const double wave_length = random.between (70, 110); // [m]
  street.relief = drawRelief (amplitude, wave_length, random);
  street.lidar.steps = int (drawLogUniform (370, 1800, random));
  for (const double side : {-1.0, 1.0})
    for (double x = -half_length; x < half_length; x += distance_of_houses)
      if (random.chance (chance_of_house))
        addHouse (street, x, side, random);
  const auto bushes = std::size_t (random.between (300, 700));
  while (street.bushes.size() < bushes)
    street.bushes.push_back (drawBush (street, random));
  return street;
}

SimulatedCloud
scanHillyStreet (const HillyStreet& street, double noise, Seed seed, bool organized)
{
  const ShapeTree walls = treeOf (street.walls);
  const Vector3d eye = Vector3d::Zero();
  Random leaves = randomFor (Purpose::Bushes, seed);
  const auto cast = [&] (const Vector3d& ray) {
    Hit nearest{distanceToGround (street, ray), unknown_surface};
    const auto replaceIfNearer = [&nearest] (const Hit& hit) {
      if (hit.distance > nearest_reading && hit.distance < nearest.distance)
        nearest = hit;
    };
    replaceIfNearer (castRay (walls, eye, ray));
    for (const Bush& bush : street.bushes)
      replaceIfNearer ({distanceToBush (bush, ray, leaves), no_surface});
    return nearest;
  };
  const Scan scan = scanAround (cast, street.lidar, noise, seed);
  return labeledBySize (toSurfaceCloud (scan, Isometry3d::Identity(), organized),
                        surfacePlanes (street.walls));
}

} // namespace pcl_ops::simulation
