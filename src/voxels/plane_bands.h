// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud/points.h"
#include "geometry/float_plane.h"
#include <pcl_ops/plane.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace pcl_ops::internal {

/** \brief The space around a plane in which the plane takes points, on both sides; and
 * the noise sigma of its points, by which a point chooses among several planes. */
struct PlaneBand {
  FloatPlane surface;
  /** \brief Distance below which the plane takes points [m]; 0: it takes no point. */
  float half_width = 0.0f;
  /** \brief 1 / sigma^2 [1/m^2]. */
  float inverse_variance = 0.0f;
  /** \brief ln sigma^2 = 2 ln sigma, with sigma in meters. */
  float log_variance = 0.0f;

  PlaneBand() = default;

  /** \param[in] noise sigma [m], above 0
   * \param[in] max_distance becomes \ref half_width [m] */
  PlaneBand (const Plane& plane, double noise, double max_distance)
  : surface (plane)
  , half_width (static_cast<float> (max_distance))
  , inverse_variance (static_cast<float> (1.0 / (noise * noise)))
  , log_variance (static_cast<float> (2.0 * std::log (noise)))
  {}
};

/** \brief The plane that a point most likely belongs to: of the planes in whose bands
 * the point lies, the one with the least d^2 / sigma^2 + 2 ln sigma, where d is the
 * distance of the point; no_plane if the point lies in no band. But for a constant that
 * is -2 times the logarithm of the normal distribution of d. With d / sigma alone a
 * noisy plane would take points of a clean plane that it meets.
 * \param[in] planes the candidates, as positions in \p bands
 * \param[in] point index of the point in \p points */
inline std::int32_t
likeliestOf (const Labels& planes,
             const std::vector<PlaneBand>& bands,
             const Coordinates& points,
             std::uint32_t point)
{
  std::int32_t likeliest = no_plane;
  float least_cost = std::numeric_limits<float>::infinity();
  for (const std::int32_t plane : planes) {
    const PlaneBand& candidate = bands[plane];
    const float distance =
        candidate.surface.distance (points.x[point], points.y[point], points.z[point]);
    const float cost =
        candidate.inverse_variance * distance * distance + candidate.log_variance;
    const bool is_likelier = distance < candidate.half_width && cost < least_cost;
    likeliest = is_likelier ? plane : likeliest;
    least_cost = is_likelier ? cost : least_cost;
  }
  return likeliest;
}

/** \brief Appends a plane to a list, unless it is no_plane or in the list already. */
inline void
addOnce (std::int32_t plane, Labels& planes)
{
  if (plane != no_plane &&
      std::find (planes.begin(), planes.end(), plane) == planes.end())
    planes.push_back (plane);
}

} // namespace pcl_ops::internal
