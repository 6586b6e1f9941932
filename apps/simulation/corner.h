// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "room.h"

namespace pcl_ops::simulation {

/** \brief Draws the corner of a room, a floor and two walls, with tables, benches and
 * racks of boards on posts: narrow planes beside wide ones.
 * \param[in] seed the same seed gives the same corner */
Room
makeFurnishedCorner (std::uint32_t seed);

} // namespace pcl_ops::simulation
