// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene.h"

namespace pcl_ops::simulation {

// Each of these draws a piece of furniture that stands on z = 0 around the origin, with
// its back towards -y.

/** A desk, a cupboard, a shelf, a bed, a sofa or a leaning board. */
Body
drawAtWall (Random& random);
/** A table, a chair, cartons, a panel tilted by 25 to 75 degrees, or round things. */
Body
drawAnywhere (Random& random);
/** A tilted board against a wall. */
Body
drawLeaningBoard (Random& random);
/** A tilted board on two posts. */
Body
drawRamp (Random& random);
/** A ball, a bin, a lamp or a rolled carpet; none has a planar face. */
Body
drawRoundClutter (Random& random);

// These have boards on four square posts; boards and posts are 2 to 6 cm thick. Each
// face is a surface, however narrow. No two faces of a piece are coplanar: a detector
// would be right to join such faces.

/** One board at a height of 0.6 to 0.8 m. */
Body
drawBoardTable (Random& random);
/** One narrower board at a height of 0.4 to 0.5 m. */
Body
drawBoardBench (Random& random);
/** Three or four boards above each other. */
Body
drawBoardRack (Random& random);

} // namespace pcl_ops::simulation
