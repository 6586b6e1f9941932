// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/buildings/floor_plan.h>

#include <vector>

namespace pcl_ops::internal::buildings {

/** \brief Whether a place is within the outline of a room, and in no hole of it. */
bool
isInRoom (const PlanRoom& room, const Eigen::Vector2d& place);

/** \brief Tells each opening which rooms are before and behind its wall. */
void
findRoomsOfOpenings (const std::vector<PlanRoom>& rooms, std::vector<PlanWall>& walls);

} // namespace pcl_ops::internal::buildings
