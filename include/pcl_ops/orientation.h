// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <pcl_ops/export.h>

#include <cmath>

namespace pcl_ops {

/** \brief 7 degrees [rad]: the paper's tolerance for orientations and for merging. */
constexpr double paper_angle_tolerance = 7.0 * (M_PI / 180.0);

/** \brief Returns the direction against gravity in the optical frame of a level camera:
 * x points to the right, y down, z ahead. */
inline Eigen::Vector3d
cameraUp ()
{
  return -Eigen::Vector3d::UnitY();
}

/** \brief The paper's three groups of planes (section III-A). */
enum class Orientation { Horizontal, Vertical, Other };

/** \brief "horizontal", "vertical" or "other". */
PCL_OPS_EXPORT const char*
toString (Orientation orientation);

/** \brief Returns the orientation of a plane.
 * \param[in] normal unit normal of either sign
 * \param[in] up unit vector against gravity, in the same frame
 * \param[in] tolerance for a horizontal plane, the largest angle between the normal
 * and the up axis [rad]; for a vertical plane, the largest angle between the normal and
 * the horizontal */
PCL_OPS_EXPORT Orientation
orientationOf (const Eigen::Vector3d& normal,
               const Eigen::Vector3d& up,
               double tolerance);

/** \brief Returns the angle between a plane and the horizontal, 0 to pi/2 [rad].
 * \param[in] normal of the plane, of either sign and any length but 0
 * \param[in] up against gravity, in the same frame, of any length but 0 */
PCL_OPS_EXPORT double
slopeOf (const Eigen::Vector3d& normal, const Eigen::Vector3d& up);

} // namespace pcl_ops
