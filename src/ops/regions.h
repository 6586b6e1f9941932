// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ops/place_noise.h"
#include <pcl_ops/plane.h>

#include <optional>
#include <vector>

namespace pcl_ops::internal {

/** \brief Places on one plane that touch each other. */
struct Region {
  /** \brief About the zero of the local frame. */
  Moments moments;
  PlaneFit fit;
  /** \brief The median scatter of its places, by their chosen supports, and the
   * geometric mean of their noise [m]. Of joined regions means weighted by points. */
  double scatter = 0.0;
  double noise = 0.0;
  /** \brief Whether it has parts that may lean away from each other, and not only taken
   * scraps. */
  bool is_joined = false;

  /** \brief Extent in the narrower direction, and in the longer one [m]. */
  double
  width () const;
  double
  length () const;

  /** \brief Fits its plane to its points, if they are enough to tell it. */
  void
  refit ();

  /** \brief Takes the points of another one, which is empty then; needs a refit(). */
  void
  take (Region& other);
};

struct Regions {
  std::vector<Region> list;
  /** \brief For each place the position in the list of its region; no_plane: none. */
  Labels of_place;
};

/** \brief Lets regions grow from the flattest places over their neighbors, one after
 * the other; a place goes into the first region that it fits.
 * \param[in] distance_threshold largest distance of a place to its plane [m]; where it is
 * not given, the noise limits it */
Regions
growRegions (const Places& places,
             const PlaceNoise& noise,
             const ChosenSupports& chosen,
             std::optional<double> distance_threshold);

} // namespace pcl_ops::internal
