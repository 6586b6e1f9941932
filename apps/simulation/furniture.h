// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene.h"

namespace pcl_ops::simulation {

/** \brief A piece of furniture standing on z = 0 around the origin, its back towards
 * -y. */
struct Furniture {
  Body body;
  /** \brief Extent on the floor along x and y [m]. */
  Eigen::Vector2d footprint = Eigen::Vector2d::Zero();
};

/** \brief Something with its back to a wall: a desk, a cupboard, a shelf, a bed, a sofa
 * or a board as of \ref drawLeaningBoard. All sizes are common in homes and offices. */
Furniture
drawAtWall (Random& random);

/** \brief Something in the room: a table, a chair, cartons, a panel of any tilt on a
 * post, or round things. */
Furniture
drawAnywhere (Random& random);

/** \brief A board that leans on the wall behind it. */
Furniture
drawLeaningBoard (Random& random);

/** \brief A wide board with one edge on the floor, the other raised. */
Furniture
drawRamp (Random& random);

/** \brief A ball, a bin, a lamp or a rolled carpet: nothing planar. */
Furniture
drawRoundClutter (Random& random);

} // namespace pcl_ops::simulation
