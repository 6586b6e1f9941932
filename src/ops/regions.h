// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ops/place_noise.h"
#include <pcl_ops/plane.h>

#include <optional>
#include <vector>

namespace pcl_ops::internal {

/** \brief Places on one plane, connected by their neighborhoods or joined later. */
struct Region {
  /** \brief Moments of its places about the origin of the local frame. */
  Moments moments;
  /** \brief Its plane. \ref take does not change it: see \ref refit. */
  PlaneFit fit;
  /** \brief Median scatter of the chosen supports of its places [m]. A join averages
   * the squared scatter of both regions, weighted by points. */
  double scatter = 0.0;
  /** \brief Geometric mean of the noise of its places [m]. A join averages the noise of
   * both regions, weighted by points. */
  double noise = 0.0;
  /** \brief Whether it took a region with more than PlaceConstants::min_share_of_part
   * times as many points as it had itself. Such a part may tilt against the rest. */
  bool has_parts = false;

  /** \brief Extent along the shorter axis in the plane [m]: the width of a uniform
   * distribution with the variance of its points. */
  double
  width () const;

  /** \brief The same along the longer axis in the plane [m]. */
  double
  length () const;

  /** \brief Fits its plane to its points; keeps the old plane if these are fewer than
   * six or on a line. */
  void
  refit ();

  /** \brief Takes all points of another region, which is then empty. Call refit()
   * afterwards. */
  void
  take (Region& other);
};

/** \brief The regions of a cloud, and which of its places are in them. */
struct Regions {
  /** \brief A region that another one took stays in the list, without points. */
  std::vector<Region> list;
  /** \brief For each place the index of its region in \ref list, or no_plane. */
  Labels of_place;
};

/** \brief Grows regions over neighboring places, one region after the other. Seeds are
 * the flat places, the flattest first. A place goes into the first region that it fits.
 * A flat place that fits none begins a region; others that fit none are in no region.
 * \param[in] distance_threshold largest distance of a place to the plane of its region
 * [m]; if not given, it follows the noise */
Regions
growRegions (const Places& places,
             const PlaceNoise& noise,
             const ChosenSupports& chosen,
             std::optional<double> distance_threshold);

} // namespace pcl_ops::internal
