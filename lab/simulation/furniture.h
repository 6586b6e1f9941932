// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene.h"

namespace pcl_ops::simulation {

/** Draws a piece of furniture that stands on z = 0 around the origin, with its back
 * towards -y. */
using DrawFurniture = Body (Random& random);

/** A desk, a cupboard, a shelf, a bed, a sofa or a leaning board. */
DrawFurniture drawAtWall;
/** A table, a chair, cartons, a panel tilted by 25 to 75 degrees, or round things. */
DrawFurniture drawAnywhere;
/** A board against a wall, and a board on two posts, both tilted. */
DrawFurniture drawLeaningBoard, drawRamp;
/** A ball, a bin, a lamp or a rolled carpet: nothing is planar. */
DrawFurniture drawRoundClutter;

/** Boards on four square posts; boards and posts are 2 to 6 cm thick. Each face is a
 * surface, however narrow. No two faces of a piece are coplanar: a detector would be
 * right to join such faces. */
DrawFurniture drawBoardTable, drawBoardBench, drawBoardRack;

} // namespace pcl_ops::simulation
