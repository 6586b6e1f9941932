// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pcl_ops::internal {

constexpr double pi = 3.14159265358979323846;
/** \brief 90 degrees [rad]. */
constexpr double right_angle = pi / 2.0;
/** \brief The largest angle that parameters may have [rad]. It is above \ref
 * right_angle because of rounded values: pcl::deg2rad (90) in single precision is 5e-8
 * above it. */
constexpr double max_right_angle = right_angle + 1e-6;

} // namespace pcl_ops::internal
