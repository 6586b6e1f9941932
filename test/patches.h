// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/points.h>
#include <pcl_ops/random.h>

/** \brief A parallelogram: corner + s first + t second with s and t in 0 .. 1 [m]. */
struct Patch {
  Eigen::Vector3d corner, first, second;

  Eigen::Vector3d
  normal () const
  {
    return first.cross (second).normalized();
  }
};

/** \brief Adds steps x steps points of a patch, evenly spread and without its rim.
 * \param[in] noise each point is moved by up to this much along the normal [m] */
inline void
addPatch (pcl_ops::Coordinates& points,
          const Patch& patch,
          int steps,
          double noise = 0.0,
          std::uint32_t seed = 1)
{
  pcl_ops::RandomGenerator generator (seed);
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j) {
      const double height = noise * (2.0 * pcl_ops::drawUnit (generator) - 1.0);
      const Eigen::Vector3d point = patch.corner + (i + 0.5) / steps * patch.first +
                                    (j + 0.5) / steps * patch.second +
                                    height * patch.normal();
      points.add (static_cast<float> (point.x()),
                  static_cast<float> (point.y()),
                  static_cast<float> (point.z()));
    }
}
