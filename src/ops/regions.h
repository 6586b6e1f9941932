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
  /** \brief The median of what its places scatter by, and the geometric mean of their
   * noise [m]. */
  double scatter = 0.0;
  double noise = 0.0;
  /** \brief Of parts that may lean away from each other. */
  bool is_joined = false;

  /** \brief Extent in the narrower direction, and in the longer one [m]. */
  double
  width () const;
  double
  length () const;

  /** \brief Fits its plane to its points, if they are enough to tell it. */
  void
  refit ();

  /** \brief Takes the points of another one; has to be refitted. */
  void
  take (Region& other);
};

struct Regions {
  std::vector<Region> list;
  /** \brief Which of the list each place is in; no_plane: in none. */
  Labels of_place;
};

/** \brief Lets regions grow from the flattest places over their neighbors, each place
 * into the first region that it fits.
 * \param[in] distance_threshold how far a place may be from its plane [m]; not given: by
 * the noise there */
Regions
growRegions (const Places& places,
             const PlaceNoise& noise,
             const ChosenSupports& chosen,
             std::optional<double> distance_threshold);

} // namespace pcl_ops::internal
