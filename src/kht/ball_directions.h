// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "geometry/angles.h"

#include <array>
#include <cstdint>
#include <vector>

namespace pcl_ops::internal {

/** \brief The directions of an accumulator ball (Borrmann et al. 2011): rows of equal
 * polar angle phi, pi / phi_num apart with one on each pole, each cut into
 * max (1, round (2 phi_num sin phi)) patches of azimuth theta, so that all patches have
 * about the same area. A direction is the number of a patch, row by row from the north
 * pole. */
class BallDirections {
public:
  /** \brief \param[in] phi_num number of steps from pole to pole, at least 1 */
  explicit BallDirections (int phi_num);

  int
  phiNum () const
  {
    return static_cast<int> (row_begins_.size()) - 2;
  }

  /** \brief Number of directions. */
  std::size_t
  size () const
  {
    return rows_.size();
  }

  /** \brief Angle between two rows [rad]. */
  double
  phiStep () const
  {
    return pi / phiNum();
  }

  /** \brief Number of patches of a row 0 .. phi_num. */
  int
  patchesOfRow (int row) const
  {
    return static_cast<int> (row_begins_[row + 1] - row_begins_[row]);
  }

  int
  rowOf (std::uint32_t direction) const
  {
    return rows_[direction];
  }

  /** \brief The direction of a patch of a row; any number wraps around the row. */
  std::uint32_t
  patchOfRow (int row, int patch) const;

  /** \brief The direction that holds an azimuth.
   * \param[in] row -phi_num .. 2 phi_num; a row beyond a pole is the row as far on the
   * pole's other side, half a turn on
   * \param[in] theta azimuth, any [rad] */
  std::uint32_t
  at (int row, double theta) const;

  /** \brief The polar angle and azimuth of a direction's center [rad]. */
  double
  phiOf (std::uint32_t direction) const
  {
    return rowOf (direction) * phiStep();
  }
  double
  thetaOf (std::uint32_t direction) const;

  /** \brief The unit vector of a direction's center. */
  Eigen::Vector3d
  vectorOf (std::uint32_t direction) const;

  /** \brief The direction at the other side of the ball; its own opposite is the first
   * again. */
  std::uint32_t
  opposite (std::uint32_t direction) const;

  /** \brief The directions across the four sides of a patch. */
  std::array<std::uint32_t, 4>
  beside (std::uint32_t direction) const;

  /** \brief The 3 x 3 patches around a direction, itself included: in each of three
   * rows the patch at its azimuth and one to either side. Each once, ascending. */
  std::vector<std::uint32_t>
  around (std::uint32_t direction) const;

private:
  std::vector<std::uint32_t> row_begins_;
  std::vector<std::uint16_t> rows_;
};

/** \brief Planes as (direction of the normal, distance rho from the ball's center). */
struct HoughSpace {
  BallDirections directions;
  int rho_num = 0;
  /** \brief Length of a bin of rho [m]. */
  double rho_step = 0.0;

  /** \brief The middle of a bin; bin -1 is the first one seen from the other side. */
  double
  rhoOf (int bin) const
  {
    return (bin + 0.5) * rho_step;
  }
};

} // namespace pcl_ops::internal
