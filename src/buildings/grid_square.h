// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <cmath>
#include <utility>

namespace pcl_ops::internal::buildings {

/** \brief A square of a horizontal grid, by column along x and row along y. */
using GridSquare = std::pair<long, long>;

/** \brief Returns the square of a grid at a position.
 * \param[in] edge of a square [unit of \p position] */
inline GridSquare
squareAt (const Eigen::Vector2d& position, double edge)
{
  constexpr double farthest = 1e15; // [squares]: neighbors, too, have exact indices
  const Eigen::Vector2d square =
      (position / edge).cwiseMin (farthest).cwiseMax (-farthest);
  return {std::lround (square.x()), std::lround (square.y())};
}

} // namespace pcl_ops::internal::buildings
