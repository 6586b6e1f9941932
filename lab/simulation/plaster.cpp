// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "plaster.h"

#include <iterator>

namespace pcl_ops::simulation {

namespace {

/** Returns the six sides of the room. The sensor is near its middle, at the origin. */
Shapes
sidesOfRoom ()
{
  const Vector3d size (6, 5, 3); // [m]
  Body room;
  room.addBox (at ({0.5, 0.5, 0.1}), size);
  return room.shapes;
}

/** The waves of a side; at returns how far the side bulges at a point [m]. */
struct Waves {
  double amplitude, along, across; // [m], phases [rad]

  double
  at (const Shape& side, const Vector3d& point) const
  {
    constexpr double length = 3.0;
    constexpr double width = 1.4 * length; // [m]
    const Vector3d local = point - side.center;
    return amplitude * std::sin (2.0 * pi * local.dot (side.u) / length + along) *
           std::cos (2.0 * pi * local.dot (side.v) / width + across);
  }
};

} // namespace

Plaster
drawPlaster (Seed seed)
{
  constexpr std::size_t sizes[] = {
      20'000, 50'000, 100'000, 200'000, 500'000, 1'000'000, 2'000'000};
  const std::size_t number = (std::size_t (seed) + std::size (sizes) - 1);
  Random random = randomFor (Purpose::Plaster, seed);
  return {random.between (0.002, 0.015), sizes[number % std::size (sizes)]};
}

SimulatedCloud
scanPlaster (const Plaster& plaster, double noise, Seed seed)
{
  const Shapes sides = sidesOfRoom();
  Random random = randomFor (Purpose::PlasterScan, seed);
  std::vector<Plane> planes;
  std::vector<Waves> waves;
  for (const Shape& side : sides) {
    planes.push_back (side.plane());
    const double along = random.angle (0, 360);
    waves.push_back ({noise * plaster.amplitude, along, random.angle (0, 360)});
  }
  LabeledCloud cloud =
      drawPoints (sides, plaster.points, noise * plaster_sigma, random);
  for (pcl::PointXYZL& point : cloud) {
    const Shape& side = sides[point.label - 1];
    const Vector3d flat = point.getVector3fMap().cast<double>();
    const double bulge = waves[point.label - 1].at (side, flat);
    point.getVector3fMap() = (flat + bulge * side.normal()).cast<float>();
  }
  return labeledBySize (std::move (cloud), planes);
}

} // namespace pcl_ops::simulation
