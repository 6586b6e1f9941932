// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene.h"

namespace pcl_ops::simulation {

/** \brief Draws a piece that stands on z = 0 around the origin, its back towards -y.
 * All sizes are common in homes and offices. */
using DrawFurniture = Body (Random& random);

/** \brief A desk, a cupboard, a shelf, a bed, a sofa or a leaning board. */
DrawFurniture drawAtWall;
/** \brief A table, a chair, cartons, a panel of any tilt, or round things. */
DrawFurniture drawAnywhere;
DrawFurniture drawLeaningBoard, drawRamp;
/** \brief A ball, a bin, a lamp or a rolled carpet: nothing planar. */
DrawFurniture drawRoundClutter;

/** \brief Boards on four square posts, 2 to 6 cm thick. Each face is a plane of its
 * own, however narrow; no two faces of a piece are in one plane, where a detector could
 * rightly call them one. */
DrawFurniture drawBoardTable, drawBoardBench, drawBoardRack;

} // namespace pcl_ops::simulation
