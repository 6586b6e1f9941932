// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace pcl_ops {

/** \brief Leaves have fewer points, or as many: their distances are computed at once.
 */
constexpr std::uint32_t most_points_of_leaf = 64;

} // namespace pcl_ops
