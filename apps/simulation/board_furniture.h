// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "furniture.h"

namespace pcl_ops::simulation {

/** \brief Thickness of boards and width of posts [m]. Each of their faces is a plane of
 * its own, however narrow; no two faces of a piece are in one plane, where a detector
 * could rightly call them one. */
constexpr double thinnest_board = 0.02, thickest_board = 0.06;

/** \brief A board on four square posts at the height of a table. */
Furniture
drawBoardTable (Random& random);

/** \brief The same at the height of a seat. */
Furniture
drawBoardBench (Random& random);

/** \brief Boards above each other on four square posts, narrower from one to the next.
 */
Furniture
drawBoardRack (Random& random);

} // namespace pcl_ops::simulation
