// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ops/places.h"
#include <pcl_ops/detection_report.h>

#include <optional>
#include <vector>

namespace pcl_ops::internal {

/** \brief What a cloud says about its noise before any plane is found.
 *
 * Supports of white noise scatter alike at all sizes. Where neighbors err alike, as in
 * images of depth cameras, small supports scatter by too little, and larger ones by
 * more, until they hold many independent errors: from there on they are level. */
struct PlaceNoise {
  /** \brief Of each place, in its largest supports [m]. */
  std::vector<float> of_place;
  /** \brief What all places say together. */
  CloudNoise cloud;

  /** \brief By how much supports of a level grow until they are level. A part of a
   * cloud may have fewer levels than the whole, and a small sample of it fewer than a
   * part. */
  double
  growthOf (std::size_t level) const
  {
    return level < cloud.growth.size() ? cloud.growth[level] : 1.0;
  }
};

/** \param[in] whole what the cloud says of which these are some places; none if these
 * are all */
PlaceNoise
noiseOfPlaces (const Places& places,
               const std::optional<CloudNoise>& whole,
               unsigned threads);

/** \brief What each place is taken for while planes grow: the largest of its supports
 * that its noise explains. */
struct ChosenSupports {
  std::vector<Eigen::Vector3d> normal;
  std::vector<float> scatter, width;
  std::vector<char> is_flat;
};

ChosenSupports
chooseSupports (const Places& places, const PlaceNoise& noise, unsigned threads);

} // namespace pcl_ops::internal
