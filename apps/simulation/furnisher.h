// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "furniture.h"
#include "room.h"

#include <vector>

namespace pcl_ops::simulation {

/** \brief Places pieces of furniture one by one where there is still room for them;
 * those for which there is none are left out. */
class Furnisher {
public:
  /** \param[in,out] room takes the pieces
   * \param[in] walls that it has, the first of the four
   * \param[in,out] generator source of all places */
  Furnisher (Room& room, std::uint32_t walls, internal::RandomGenerator& generator);

  /** \brief With its back to some wall. */
  void
  placeAtWall (const Furniture& furniture);

  /** \brief Anywhere in the room, turned in any way. */
  void
  placeAnywhere (const Furniture& furniture);

private:
  template <typename DrawPose>
  void
  place (const Furniture& furniture, DrawPose drawPose);

  bool
  isFree (const Eigen::AlignedBox2d& covered) const;

  Room& room_;
  std::uint32_t walls_;
  internal::RandomGenerator& generator_;
  /** \brief The floor below the pieces. */
  std::vector<Eigen::AlignedBox2d> covered_;
};

} // namespace pcl_ops::simulation
