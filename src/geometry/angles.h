// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pcl_ops::internal {

constexpr double pi = 3.14159265358979323846;
/** \brief 90 degrees [rad]. */
constexpr double right_angle = pi / 2.0;

} // namespace pcl_ops::internal
