// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulated_cloud.h"

#include <cmath>

namespace pcl_ops::simulation {

/** \brief A round surface about an upright axis, or a part of one. */
struct RoundShape {
  /** \brief A dome is the top of a sphere; a cylinder has no ends, a cone no base. */
  enum class Kind { Dome, Cylinder, Cone, Torus };
  Kind kind = Kind::Dome;
  Vector3d center = Vector3d::Zero(); // of the dome its sphere's; of the cone its apex
  double radius = 1.0; // of sphere, cylinder, the cone's base or the torus's ring [m]
  double height = 0.1; // of dome or cone, half that of cylinder or torus [m]
  double share = 1.0;  // of a turn, around +y from the axis; 1 of a dome

  double
  area () const
  {
    return kind == Kind::Cylinder ? share * (4.0 * pi * radius * height)
           : kind == Kind::Cone   ? share * (pi * radius * std::hypot (radius, height))
           : kind == Kind::Torus  ? share * (4.0 * pi * pi * radius * height)
                                  : 2.0 * pi * radius * height;
  }
};

SurfacePoint
drawPoint (const RoundShape& shape, Random& random);

/** \brief Standard deviation of the points of shapes [m]. */
constexpr double shapes_sigma = 0.002;

/** \brief About 5000 points on a square meter. */
constexpr std::size_t points_of_shapes = 250'000;

/** \brief A sphere, a cylinder, a cone and a torus in a row, behind them parts of four
 * larger ones, apart from each other and from a ground and a board on it. The radii are
 * from 0.1 to 5.5 m: up to some 100 of the finer voxels that the default detector looks
 * for planes in. All surfaces are scanned evenly, whatever hides them, from no known
 * position; z is up, z = 0 the ground. */
SimulatedCloud
simulateShapes (std::size_t points, double noise, Seed seed);

} // namespace pcl_ops::simulation
