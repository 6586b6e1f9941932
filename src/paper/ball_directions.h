// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "geometry/angles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace pcl_ops::internal {

/** \brief The directions of normals that 3D-KHT votes for: an accumulator ball
 * (Borrmann et al. 2011).
 *
 * The ball has phi_num + 1 rows of constant polar angle phi, pi / phi_num apart. The
 * first and the last row are the poles. Each row is divided along the azimuth theta
 * into max (1, round (2 phi_num sin phi)) patches, so that all patches have about the
 * same area. A direction is the index of a patch, counted row by row from the north
 * pole (+z). */
struct BallDirections {
  /** \brief Number of steps from pole to pole, at least 1. */
  int phi_num;
  /** \brief Length of a step [rad]. */
  double phi_step;
  /** \brief The row of each direction, 0 .. phi_num. */
  std::vector<std::uint16_t> row_of;
  /** \brief First direction of each row, then the number of directions. */
  std::vector<std::uint32_t> row_begins;

  explicit BallDirections (int steps)
  : phi_num (steps), phi_step (pi / steps), row_begins (1, 0)
  {
    for (int row = 0; row <= phi_num; ++row) {
      const double circumference = 2.0 * phi_num * std::sin (row * pi / phi_num);
      const long patches = std::max (1L, std::lround (circumference));
      row_of.insert (row_of.end(), patches, static_cast<std::uint16_t> (row));
      row_begins.push_back (static_cast<std::uint32_t> (row_of.size()));
    }
  }

  /** \brief Number of directions. */
  std::size_t
  size () const
  {
    return row_of.size();
  }

  int
  patchesOfRow (int row) const
  {
    return static_cast<int> (row_begins[row + 1] - row_begins[row]);
  }

  /** \brief The direction of a patch of a row.
   * \param[in] patch from 0 on along the azimuth; others wrap around the row */
  std::uint32_t
  patchOfRow (int row, int patch) const
  {
    const int patches = patchesOfRow (row);
    const int wrapped = patch % patches;
    return row_begins[row] +
           static_cast<std::uint32_t> (wrapped < 0 ? wrapped + patches : wrapped);
  }

  /** \brief The direction whose patch in a row contains an azimuth.
   * \param[in] row -phi_num .. 2 phi_num. A row beyond a pole continues on the other
   * side of the ball: row -2 at theta is row 2 at theta + pi.
   * \param[in] theta azimuth [rad], also beyond a full turn */
  std::uint32_t
  at (int row, double theta) const
  {
    const bool is_beyond_pole = row < 0 || row > phi_num;
    const int reflected = row < 0 ? -row : is_beyond_pole ? 2 * phi_num - row : row;
    const double turns = theta / (2.0 * pi) + (is_beyond_pole ? 0.5 : 0.0);
    const double patch = std::floor (turns * patchesOfRow (reflected));
    return patchOfRow (reflected, static_cast<int> (patch));
  }

  /** \brief The polar angle of a direction's center [rad]. */
  double
  phiOf (std::uint32_t direction) const
  {
    return row_of[direction] * phi_step;
  }

  /** \brief The azimuth of a direction's center [rad]. */
  double
  thetaOf (std::uint32_t direction) const
  {
    const int row = row_of[direction];
    return 2.0 * pi * (direction - row_begins[row] + 0.5) / patchesOfRow (row);
  }

  /** \brief The unit vector of a direction's center. */
  Eigen::Vector3d
  vectorOf (std::uint32_t direction) const
  {
    const int row = row_of[direction];
    if (row == 0 || row == phi_num)
      return Eigen::Vector3d (0.0, 0.0, row == 0 ? 1.0 : -1.0);
    const double phi = phiOf (direction);
    const double theta = thetaOf (direction);
    return Eigen::Vector3d (std::sin (phi) * std::cos (theta),
                            std::sin (phi) * std::sin (theta),
                            std::cos (phi));
  }

  /** \brief The direction on the opposite side of the ball: opposite (opposite (d))
   * is d. */
  std::uint32_t
  opposite (std::uint32_t direction) const
  {
    const int row = row_of[direction];
    const int patches = patchesOfRow (row);
    // With an odd number of patches, half a turn ends on the border of two patches. A
    // direction of the northern half gets the later patch, a direction of the southern
    // half the earlier patch, so that the two are opposite to each other.
    const int half_turn = 2 * row <= phi_num ? (patches + 1) / 2 : patches / 2;
    const int patch = static_cast<int> (direction - row_begins[row]);
    return patchOfRow (phi_num - row, patch + half_turn);
  }

  /** \brief The directions north, south, west and east of a direction. Beyond a pole,
   * north or south is on the other side of the ball; west and east of a pole are the
   * pole itself. */
  std::array<std::uint32_t, 4>
  beside (std::uint32_t direction) const
  {
    const int row = row_of[direction];
    const double theta = thetaOf (direction);
    const int patch = static_cast<int> (direction - row_begins[row]);
    const std::uint32_t west = patchOfRow (row, patch - 1);
    return {
        at (row - 1, theta), at (row + 1, theta), west, patchOfRow (row, patch + 1)};
  }

  /** \brief The 3 x 3 neighborhood of a direction, itself included: in its row and the
   * rows north and south of it, the patch at its azimuth and one to either side.
   * Ascending, each direction once. */
  std::vector<std::uint32_t>
  around (std::uint32_t direction) const
  {
    const std::array<std::uint32_t, 4> sides = beside (direction);
    const std::uint32_t north = sides[0];
    const std::uint32_t south = sides[1];
    std::vector<std::uint32_t> found;
    for (const std::uint32_t middle : {north, direction, south}) {
      const int row = row_of[middle];
      const int patch = static_cast<int> (middle - row_begins[row]);
      for (const int offset : {-1, 0, 1})
        found.push_back (patchOfRow (row, patch + offset));
    }
    std::sort (found.begin(), found.end());
    found.erase (std::unique (found.begin(), found.end()), found.end());
    return found;
  }
};

/** \brief The bins of planes: each has a direction of normals, and a range of distances
 * rho from the center of the ball. */
struct HoughSpace {
  BallDirections directions;
  /** \brief Number of bins of rho. */
  int rho_num = 0;
  /** \brief Length of a bin of rho [m]. */
  double rho_step = 0.0;

  /** \brief Rho at the middle of a bin [m]; bin -1 is bin 0 of the opposite direction.
   */
  double
  rhoOf (int bin) const
  {
    return (bin + 0.5) * rho_step;
  }
};

} // namespace pcl_ops::internal
