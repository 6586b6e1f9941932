// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dense_scan.h"

namespace pcl_ops::simulation {

/** \brief A sphere, a cylinder, a cone and a torus in a row, behind them parts of four
 * larger ones, apart from each other and from a ground and a board on it: what is no
 * plane beside what is one. The radii are from 0.1 to 5.5 m: at \ref points_of_shapes
 * up to some 100 of the finer voxels that the default detector looks for planes in. z
 * is up, z = 0 the ground. */
struct Shapes {
  /** \brief The smaller four first. */
  std::vector<RoundShape> round;
  Rectangle ground, board;
};

/** \brief Standard deviation of the points of shapes [m]. */
constexpr double shapes_sigma = 0.002;

/** \brief About 5000 points on a square meter. */
constexpr std::size_t points_of_shapes = 250'000;

/** \brief Draws sizes, and how the board stands. */
Shapes
makeShapes (std::uint32_t seed);

/** \brief Scans all surfaces evenly, whatever hides them, from no known position: the
 * sensor's origin is 0 0 0. The points follow the shapes one after the other.
 * \param[in] points exact number of points
 * \param[in] noise_scale factor on \ref shapes_sigma, the noise along the normal */
SimulatedCloud
scanShapes (const Shapes& shapes,
            std::size_t points,
            double noise_scale,
            std::uint32_t seed);

} // namespace pcl_ops::simulation
