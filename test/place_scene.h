// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud/distinct_places.h"
#include "ops/place_noise.h"
#include "ops/regions.h"
#include "scene.h"

#include <optional>
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

/** \brief For noiseOfPlaces: the places are no part of a larger cloud. */
inline constexpr std::nullopt_t no_whole_cloud = std::nullopt;
/** \brief For growRegions: no threshold is given, so the largest distance of a place to
 * its plane follows the noise. */
inline constexpr std::nullopt_t no_threshold = std::nullopt;

/** \brief The results of the stages of detectOnPlaces up to region growing. */
struct PlaceScene {
  /** \param[in] neighborhood_size number of points of a neighborhood, its place
   * included; the default is that of a cloud of some 10,000 points */
  explicit PlaceScene (const pcl_ops::internal::Coordinates& points,
                       std::size_t neighborhood_size = 24)
  : distinct (pcl_ops::internal::distinctPlaces (points, one_thread))
  , places (pcl_ops::internal::describePlaces (distinct, neighborhood_size, one_thread))
  , noise (pcl_ops::internal::noiseOfPlaces (places, no_whole_cloud, one_thread))
  , chosen (pcl_ops::internal::chooseSupports (places, noise, one_thread))
  , regions (pcl_ops::internal::growRegions (places, noise, chosen, no_threshold))
  {}

  /** \brief Number of places of each region that is not empty, in descending order. */
  std::vector<std::size_t>
  sizes () const
  {
    std::vector<std::size_t> descending;
    for (const pcl_ops::internal::Region& region : regions.list)
      if (region.moments.count > 0.0)
        descending.push_back (static_cast<std::size_t> (region.moments.count));
    std::sort (descending.rbegin(), descending.rend());
    return descending;
  }

  pcl_ops::internal::DistinctPlaces distinct;
  pcl_ops::internal::Places places;
  pcl_ops::internal::PlaceNoise noise;
  pcl_ops::internal::ChosenSupports chosen;
  pcl_ops::internal::Regions regions;
};

/** \brief A level square of 2 m x 2 m with a corner at the origin. */
inline const Surface square_of_ground = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}};
