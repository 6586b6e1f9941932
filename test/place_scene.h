// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud/distinct_places.h"
#include "ops/place_noise.h"
#include "ops/regions.h"
#include "scene.h"

#include <vector>

/** \brief Points drawn uniformly on surfaces, in the order of the surfaces.
 * \param[in] spacing mean distance of neighboring points [m]
 * \param[in] noise standard deviation along the normal [m] */
inline pcl_ops::internal::Coordinates
drawnOn (const std::vector<Surface>& surfaces, double spacing, double noise)
{
  pcl_ops::internal::Coordinates points;
  RandomGenerator generator (seedOfTest());
  for (const Surface& surface : surfaces) {
    const long number = std::lround (surface.area() / (spacing * spacing));
    for (long i = 0; i < number; ++i) {
      const pcl::PointXYZ point = toPoint (drawPointOf (surface, noise, generator));
      points.add (point.x, point.y, point.z);
    }
  }
  return points;
}

/** \brief The results of the engine's stages up to region growing. */
struct PlaceScene {
  explicit PlaceScene (const pcl_ops::internal::Coordinates& points,
                       std::size_t neighbors = 24)
  : distinct (pcl_ops::internal::distinctPlaces (points, 1))
  , places (pcl_ops::internal::describePlaces (distinct, neighbors, 1))
  , noise (pcl_ops::internal::noiseOfPlaces (places, std::nullopt, 1))
  , chosen (pcl_ops::internal::chooseSupports (places, noise, 1))
  , regions (pcl_ops::internal::growRegions (places, noise, chosen, std::nullopt))
  {}

  /** \brief Number of points of each region that is not empty, in descending order. */
  std::vector<std::size_t>
  sizes () const
  {
    std::vector<std::size_t> sizes;
    for (const pcl_ops::internal::Region& region : regions.list)
      if (region.moments.count > 0.0)
        sizes.push_back (static_cast<std::size_t> (region.moments.count));
    std::sort (sizes.rbegin(), sizes.rend());
    return sizes;
  }

  pcl_ops::internal::DistinctPlaces distinct;
  pcl_ops::internal::Places places;
  pcl_ops::internal::PlaceNoise noise;
  pcl_ops::internal::ChosenSupports chosen;
  pcl_ops::internal::Regions regions;
};

/** \brief A level square of 2 m x 2 m with a corner at the origin. */
inline const Surface square_of_ground = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}};
