// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/buildings/floor_plan.h>

#include <vector>

// The graph of rooms: its edges are openings, of which each knows the rooms before and
// behind its wall. FloorPlan::roomsBehindDoorsOf reads it.
namespace pcl_ops::internal::buildings {

/** \brief Returns whether a position is inside the outline of a room and outside of its
 * holes. */
bool
isInRoom (const PlanRoom& room, const Eigen::Vector2d& position);

/** \brief Sets room_before and room_behind of each opening of the walls. */
void
findRoomsOfOpenings (const std::vector<PlanRoom>& rooms, std::vector<PlanWall>& walls);

} // namespace pcl_ops::internal::buildings
