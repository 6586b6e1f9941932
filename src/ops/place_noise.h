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
 * more, until they hold many independent errors: from there on they are settled. */
struct PlaceNoise {
  /** \brief Of each place: what it would scatter by in settled supports [m]. */
  std::vector<float> of_place;
  /** \brief What all places say together. */
  CloudNoise cloud;

  /** \brief By how much the scatter of supports of a level grows until they are
   * settled. Levels without a value do not grow: a part of a cloud may have fewer
   * levels than the whole, and a small sample of it fewer than the part. */
  double
  growthOf (std::size_t level) const
  {
    return level < cloud.growth.size() ? cloud.growth[level] : 1.0;
  }
};

/** \brief Measures the noise of each place.
 * \param[in] whole what the whole cloud says, if these are the places of a part of it */
PlaceNoise
noiseOfPlaces (const Places& places,
               const std::optional<CloudNoise>& whole,
               unsigned threads);

/** \brief One support for each place, by which regions grow: the largest that its noise
 * explains. Members are those of \ref Support. */
struct ChosenSupports {
  std::vector<Eigen::Vector3d> normal;
  std::vector<float> scatter, width;
  std::vector<char> is_flat;
};

/** \brief Chooses the largest support of each place that scatters by no more than its
 * noise says; the smallest where all scatter by more, unless the nearest points are in
 * two layers, as the sides of a thin wall: then the flattest. */
ChosenSupports
chooseSupports (const Places& places, const PlaceNoise& noise, unsigned threads);

} // namespace pcl_ops::internal
