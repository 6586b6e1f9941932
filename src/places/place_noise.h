// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "places/places.h"

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
  /** \brief By how much supports of each level grow until they are level; 1 and more.
   */
  std::vector<double> growth;
  /** \brief How many neighboring points err as one; 1 for white noise. */
  double common_errors = 1.0;
};

PlaceNoise
noiseOfPlaces (const Places& places, unsigned threads);

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
