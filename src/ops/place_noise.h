// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ops/places.h"
#include <pcl_ops/detection_report.h>

#include <optional>
#include <vector>

namespace pcl_ops::internal {

/** \brief The noise of a cloud, measured before any plane is found.
 *
 * With white noise supports of all sizes have the same scatter. With correlated noise,
 * as in depth images, neighboring points err alike: the scatter of small supports is
 * less than the noise. The scatter grows from level to level until a support holds many
 * independent errors. From that level on supports are settled. */
struct PlaceNoise {
  /** \brief Noise of each place [m]: the scatter expected in settled supports, averaged
   * over nearby places and limited by the usual noise. */
  std::vector<float> of_place;
  /** \brief The noise statistics of the whole cloud: measured on the places, or given
   * if they are a part of it. */
  CloudNoise cloud;

  /** \brief Returns the growth of a level: the scatter of settled supports over that of
   * supports of the level. It is 1 for a level without a value. Such levels exist if
   * \ref cloud was measured on a sample that is smaller than these places. */
  double
  growthOf (std::size_t level) const
  {
    return level < cloud.growth.size() ? cloud.growth[level] : 1.0;
  }
};

/** \brief Measures the noise of each place.
 * \param[in] whole the noise of the whole cloud if \p places are a part of it; if not
 * given, the function measures it from \p places */
PlaceNoise
noiseOfPlaces (const Places& places,
               const std::optional<CloudNoise>& whole,
               unsigned threads);

/** \brief For each place the one of its supports that growing regions use: a list for
 * each member of \ref Support, with an entry for each place. */
struct ChosenSupports {
  std::vector<Eigen::Vector3d> normal;
  std::vector<float> scatter, width;
  std::vector<char> is_flat;
};

/** \brief Chooses for each place the largest support whose scatter is explained by the
 * noise of the place. If there is none, chooses the smallest support; but the flattest
 * one if the nearest points are in two layers, as the sides of a thin wall. */
ChosenSupports
chooseSupports (const Places& places, const PlaceNoise& noise, unsigned threads);

} // namespace pcl_ops::internal
