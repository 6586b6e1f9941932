// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud/points.h"
#include <pcl_ops/plane.h>

#include <cmath>
#include <cstddef>

namespace pcl_ops::internal {

/** \brief A \ref Plane in single precision, as the coordinates of points are. */
struct FloatPlane {
  float nx = 0.0f, ny = 0.0f, nz = 0.0f; // unit normal
  float offset = 0.0f;                   // [m]

  FloatPlane() = default;

  explicit FloatPlane (const Plane& plane)
  : nx (static_cast<float> (plane.normal.x()))
  , ny (static_cast<float> (plane.normal.y()))
  , nz (static_cast<float> (plane.normal.z()))
  , offset (static_cast<float> (plane.offset))
  {}

  /** \brief Unsigned distance of a point [m]. */
  float
  distance (float x, float y, float z) const
  {
    return std::abs (nx * x + ny * y + nz * z + offset);
  }
};

/** \brief Calls visit (i, distance) for each i from begin to end - 1, with the unsigned
 * distance of point i to the plane [m]. The compiler vectorizes the loop if visit has
 * no branch. */
template <typename Visit>
inline void
forDistances (const FloatPlane& plane,
              const Coordinates& points,
              std::size_t begin,
              std::size_t end,
              Visit&& visit)
{
  const FloatPlane copy = plane; // visit cannot change it, as far as the compiler knows
  const float* const x = points.x.data();
  const float* const y = points.y.data();
  const float* const z = points.z.data();
  for (std::size_t i = begin; i < end; ++i)
    visit (i, copy.distance (x[i], y[i], z[i]));
}

} // namespace pcl_ops::internal
