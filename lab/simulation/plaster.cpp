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
  const Vector3d size (6, 5, 3);         // [m]
  const Vector3d middle (0.5, 0.5, 0.1); // [m]
  Body room;
  room.addBox (at (middle), size);
  return room.shapes;
}

/** The waves of a side, a product of a wave along each of its edges. */
struct Waves {
  double amplitude;        // [m]
  double phase_u, phase_v; // along the edges of the side [rad]

  /** Returns how far the side bulges along its normal at a point of the flat side [m].
   */
  double
  bulgeAt (const Shape& side, const Vector3d& point) const
  {
    constexpr double length_u = 3.0;            // [m]
    constexpr double length_v = 1.4 * length_u; // [m]
    const Vector3d local = point - side.center;
    return amplitude * std::sin (2.0 * pi * local.dot (side.u) / length_u + phase_u) *
           std::cos (2.0 * pi * local.dot (side.v) / length_v + phase_v);
  }
};

} // namespace

Plaster
drawPlaster (Seed seed)
{
  constexpr std::size_t sizes[] = {
      20'000, 50'000, 100'000, 200'000, 500'000, 1'000'000, 2'000'000};
  // Seed 1 has the first size, seed 0 the last one: seed - 1, modulo the number of
  // sizes.
  const std::size_t from_first = std::size_t (seed) + std::size (sizes) - 1;
  Random random = randomFor (Purpose::Plaster, seed);
  return {random.between (0.002, 0.015), sizes[from_first % std::size (sizes)]};
}

SimulatedCloud
scanPlaster (const Plaster& plaster, double noise_factor, Seed seed)
{
  const Shapes sides = sidesOfRoom();
  Random random = randomFor (Purpose::PlasterScan, seed);
  std::vector<Plane> planes;
  std::vector<Waves> waves;
  for (const Shape& side : sides) {
    planes.push_back (side.plane());
    const double phase_u = random.angle (0, 360);
    const double phase_v = random.angle (0, 360);
    waves.push_back ({noise_factor * plaster.amplitude, phase_u, phase_v});
  }
  LabeledCloud cloud =
      drawPoints (sides, plaster.points, noise_factor * plaster_sigma, random);
  for (pcl::PointXYZL& point : cloud) {
    // Labels are numbers of sides, from 1.
    const Shape& side = sides[point.label - 1];
    const Vector3d flat = point.getVector3fMap().cast<double>();
    const double bulge = waves[point.label - 1].bulgeAt (side, flat);
    point.getVector3fMap() = (flat + bulge * side.normal()).cast<float>();
  }
  return labeledBySize (std::move (cloud), planes);
}

} // namespace pcl_ops::simulation
