// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "geometry/float_plane.h"
#include "geometry/points.h"
#include <pcl_ops/plane.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace pcl_ops::internal {

/** \brief A plane as its points see it. */
struct PlaneBand {
  FloatPlane surface;
  /** \brief Largest distance of a point [m]. */
  float band = 0.0f;
};

/** \brief Of some planes the one that a point is nearest to, in units of their bands,
 * or no_plane.
 * \param[in] planes positions of the planes that are asked for
 * \param[in] bands of all planes */
inline std::int32_t
nearestOf (const Labels& planes,
           const std::vector<PlaneBand>& bands,
           const Coordinates& points,
           std::uint32_t point)
{
  std::int32_t nearest = no_plane;
  float best = 1.0f;
  for (const std::int32_t plane : planes) {
    const PlaneBand& candidate = bands[static_cast<std::size_t> (plane)];
    const float relative =
        candidate.surface.distance (points.x[point], points.y[point], points.z[point]) /
        candidate.band;
    nearest = relative < best ? plane : nearest;
    best = std::min (best, relative);
  }
  return nearest;
}

/** \brief Adds a plane to some, each of which is there once. */
inline void
addOnce (std::int32_t plane, Labels& planes)
{
  if (plane != no_plane &&
      std::find (planes.begin(), planes.end(), plane) == planes.end())
    planes.push_back (plane);
}

} // namespace pcl_ops::internal
