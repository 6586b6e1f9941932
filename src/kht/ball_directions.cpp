// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kht/ball_directions.h"

#include <algorithm>
#include <cmath>

namespace pcl_ops::internal {

BallDirections::BallDirections (int phi_num) : row_begins_ (1, 0)
{
  for (int row = 0; row <= phi_num; ++row) {
    const double circumference = 2.0 * phi_num * std::sin (row * pi / phi_num);
    const long patches = std::max (1L, std::lround (circumference));
    rows_.insert (rows_.end(), patches, static_cast<std::uint16_t> (row));
    row_begins_.push_back (static_cast<std::uint32_t> (rows_.size()));
  }
}

std::uint32_t
BallDirections::patchOfRow (int row, int patch) const
{
  const int patches = patchesOfRow (row);
  const int wrapped = patch % patches;
  return row_begins_[row] +
         static_cast<std::uint32_t> (wrapped < 0 ? wrapped + patches : wrapped);
}

std::uint32_t
BallDirections::at (int row, double theta) const
{
  const bool beyond_pole = row < 0 || row > phiNum();
  const int reflected = row < 0 ? -row : beyond_pole ? 2 * phiNum() - row : row;
  const double turns = theta / (2.0 * pi) + (beyond_pole ? 0.5 : 0.0);
  const double patch = std::floor (turns * patchesOfRow (reflected));
  return patchOfRow (reflected, static_cast<int> (patch));
}

double
BallDirections::thetaOf (std::uint32_t direction) const
{
  const int row = rowOf (direction);
  return 2.0 * pi * (direction - row_begins_[row] + 0.5) / patchesOfRow (row);
}

Eigen::Vector3d
BallDirections::vectorOf (std::uint32_t direction) const
{
  const int row = rowOf (direction);
  if (row == 0 || row == phiNum())
    return Eigen::Vector3d (0.0, 0.0, row == 0 ? 1.0 : -1.0);
  const double phi = phiOf (direction), theta = thetaOf (direction);
  return Eigen::Vector3d (std::sin (phi) * std::cos (theta),
                          std::sin (phi) * std::sin (theta),
                          std::cos (phi));
}

std::uint32_t
BallDirections::opposite (std::uint32_t direction) const
{
  const int row = rowOf (direction);
  const int patches = patchesOfRow (row);
  // Half a turn ends between two patches where their number is odd: the northern half
  // then goes to the later one and the southern half back.
  const int half_turn = 2 * row <= phiNum() ? (patches + 1) / 2 : patches / 2;
  const int patch = static_cast<int> (direction - row_begins_[row]);
  return patchOfRow (phiNum() - row, patch + half_turn);
}

std::array<std::uint32_t, 4>
BallDirections::beside (std::uint32_t direction) const
{
  const int row = rowOf (direction);
  const double theta = thetaOf (direction);
  const int patch = static_cast<int> (direction - row_begins_[row]);
  const std::uint32_t west = patchOfRow (row, patch - 1);
  return {at (row - 1, theta), at (row + 1, theta), west, patchOfRow (row, patch + 1)};
}

std::vector<std::uint32_t>
BallDirections::around (std::uint32_t direction) const
{
  const std::array<std::uint32_t, 4> sides = beside (direction);
  std::vector<std::uint32_t> found;
  for (const std::uint32_t middle : {sides[0], direction, sides[1]}) {
    const int row = rowOf (middle);
    const int patch = static_cast<int> (middle - row_begins_[row]);
    for (const int offset : {-1, 0, 1})
      found.push_back (patchOfRow (row, patch + offset));
  }
  std::sort (found.begin(), found.end());
  found.erase (std::unique (found.begin(), found.end()), found.end());
  return found;
}

} // namespace pcl_ops::internal
