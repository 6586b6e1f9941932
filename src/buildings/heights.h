// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pcl_ops::internal::buildings {

// In meters, in square meters; why they are so is in src/doc/kinds.md.

/** \brief Planes at so nearly one height are one level. */
constexpr double same_level = 0.15;
/** \brief A step: what is higher is not the floor. */
constexpr double step = 0.3;
/** \brief Under a lower ceiling one cannot stand. */
constexpr double headroom = 1.9;
/** \brief More than the tables of a room have together: the ground [m^2]. */
constexpr double smallest_ground = 50.0;
/** \brief Between a ceiling and the floor above it. */
constexpr double thickest_deck = 0.8;
/** \brief How far below the ceiling its lower parts and the tops of walls may be. */
constexpr double drop_of_ceiling = 0.6, gap_above_wall = 0.3;

} // namespace pcl_ops::internal::buildings
