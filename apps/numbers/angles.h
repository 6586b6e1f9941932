// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pcl_ops::apps {

constexpr double pi = 3.14159265358979323846;

/** \brief Converts degrees to radians. PCL's deg2rad multiplies by a factor rounded to
 * eight digits, which makes 90 degrees more than pi / 2. */
constexpr double
toRadians (double degrees)
{
  return degrees * (pi / 180.0);
}

constexpr double
toDegrees (double radians)
{
  return radians * (180.0 / pi);
}

} // namespace pcl_ops::apps
