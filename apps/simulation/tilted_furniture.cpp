// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tilted_furniture.h"

#include "poses.h"

#include <cmath>

namespace pcl_ops::simulation {

using Eigen::Vector3d;

Furniture
makeLeaningBoard (internal::RandomGenerator& generator)
{
  const Vector3d size = drawInBox (generator, {0.5, 0.03, 0.8}, {1.3, 0.03, 1.9});
  const double lean = drawAngle (generator, 10, 35);
  const double roll = drawAngle (generator, -8, 8);
  const double depth = size.z() * std::sin (lean) + 0.1;
  const double lift = 0.5 * size.x() * std::abs (std::sin (roll));
  Furniture board{{}, {size.x() + 0.2, depth}};
  addBox (board.body,
          at (0.0, 0.5 * depth, lift) * turned (lean, Vector3d::UnitX()) *
              turned (roll, Vector3d::UnitY()) * at (0.0, 0.0, 0.5 * size.z()),
          size);
  return board;
}

Furniture
makeRamp (internal::RandomGenerator& generator)
{
  const Vector3d size = drawInBox (generator, {0.7, 1.0, 0.03}, {1.2, 1.9, 0.03});
  const double slope = drawAngle (generator, 15, 40);
  const double run = size.y() * std::cos (slope);
  const double rise = size.y() * std::sin (slope);
  Furniture ramp{{}, {size.x(), run}};
  addBox (ramp.body,
          at (0.0, 0.0, 0.5 * rise + 0.02) * turned (slope, Vector3d::UnitX()),
          size);
  for (const double side : {-0.4, 0.4})
    ramp.body.cylinders.push_back ({{side * size.x(), 0.45 * run, 0.45 * rise},
                                    Vector3d::UnitZ(),
                                    0.45 * rise,
                                    0.025});
  return ramp;
}

Furniture
makeTiltedPanel (internal::RandomGenerator& generator)
{
  const Vector3d size = drawInBox (generator, {0.7, 0.5, 0.025}, {1.3, 0.95, 0.025});
  const double height = drawBetween (generator, 0.8, 1.3);
  const double diagonal = size.head<2>().norm();
  Furniture panel{{}, {diagonal, diagonal}};
  const double yaw = drawAngle (generator, -25, 25);
  const double tilt = drawAngle (generator, 25, 75);
  addBox (panel.body,
          at (0.0, 0.0, height) * turned (tilt, Vector3d::UnitX()) *
              turned (yaw, Vector3d::UnitZ()),
          size);
  panel.body.cylinders.push_back (
      {{0.0, 0.0, 0.5 * height - 0.03}, Vector3d::UnitZ(), 0.5 * height - 0.03, 0.03});
  panel.body.cylinders.push_back ({{0.0, 0.0, 0.015}, Vector3d::UnitZ(), 0.015, 0.25});
  return panel;
}

} // namespace pcl_ops::simulation
