// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace pcl_ops::internal {

/** \brief Every number that the engine on neighborhoods was tuned with, on two clouds
 * of each set of scripts/accuracy; src/doc/decisions.md says what was tried, and
 * src/doc/places.csv what each is for: the sets with it halved and doubled. */
struct PlaceConstants {
  // The neighborhoods of places.
  /** \brief Nearest points of a place, itself included: so many times (points /
   * neighbors_cloud) ^ neighbors_growth, at most max_neighbors. Small clouds have small
   * planes; beams of a lidar are farther apart than the points along them. */
  double min_neighbors = 10.0;
  double max_neighbors = 36.0;
  double neighbors_cloud = 400.0;
  double neighbors_growth = 0.26;
  /** \brief Supports of a place, each of some 3.4 times the points of the one before.
   */
  int max_levels = 6;
  double points_per_level = 3.4;
  static constexpr int arms = 8; // neighbors that a support adds to the one before
  /** \brief The largest support has at most this share of the points. */
  double max_share_of_points = 0.1;
  /** \brief What depth on levels counts as while nearest points are looked for. */
  double depth_of_levels = 0.25;
  /** \brief Scatter over width of a support that is flat; smaller over larger variance
   * of one that is no line. */
  double max_thickness = 0.17 / 3.0;
  double min_slimness = 0.02;

  // The noise of places.
  /** \brief A support no longer thickens if it scatters by less than this times the
   * one before; a surface bends where it does so again. */
  double max_thickening = 1.25;
  double max_thickening_of_all = 1.35;
  /** \brief Share of places with level supports from which on their growth counts in
   * full, and which of them says how much supports grow. */
  double share_of_level_places = 0.1;
  double growth_quantile = 0.25;
  /** \brief Scatter over width of what is exact, as CAD models are. */
  double max_exact = 0.002;
  /** \brief What exact supports and regions may differ by, as a share of that. */
  double share_of_exact = 0.1;
  /** \brief Noise of a place in units of what is usual where points are as dense, and
   * that in units of what is usual in the cloud. */
  double min_over_usual = 0.7;
  double max_over_usual = 4.0;
  double max_usual_over_cloud = 3.0;
  /** \brief Share of places whose smallest supports are flat, from which on these alone
   * say what is usual. With all larger ones woods and hills do, too: a share of points
   * on thick planes of .04 became .15 in airborne surveys. */
  double min_telling_share = 0.02;
  /** \brief A place looks at its largest support that scatters by no more than this
   * many noises. */
  double max_noises_of_support = 1.8;
  /** \brief Nearest points are in two layers if distances from the nearer one have this
   * share of the variance at most: .36 of white noise, .25 of evenly spread ones. */
  double max_rest_of_layers = 0.05;

  // Regions.
  /** \brief Largest distance of a place to the plane of its region in units of the
   * noise, or of the rms of the region, which counts as at most this many noises. */
  double noises_of_region = 2.5;
  double max_rms_over_noise = 2.0;
  double max_noise_over_region = 2.0;
  /** \brief What surfaces bend by, in units of the width of their region. */
  double bend_of_width = 0.003;
  double max_angle = 25.0 * (M_PI / 180.0);
  double refit_growth = 1.05; // of the number of points, from one fit to the next

  // Joins.
  int join_rounds = 6;
  double noises_of_join = 2.0; // over gaps, too
  /** \brief Both regions may bend by this share of their width, and by so many noises:
   * the road of lidar64_semkitti_00 has .54 of its points in its largest plane with
   * them, .12 without; without the second, hills are one region and so no plane. The
   * number of all sets is the same. */
  double join_bend_of_width = 0.01;
  double noises_of_bend = 8.0;
  double join_angle = 5.0 * (M_PI / 180.0);
  double min_share_of_border = 0.1;
  double min_fitting_border = 0.5;
  double max_gap = 2.0; // distance of the centers over the mean of both lengths

  // Evidence for a region, a sum: above 0 it is a plane.
  double min_independent_points = 6.0;
  int min_flat_places = 2;
  /** \brief Largest rms of a plane in units of its noise. */
  double max_noises_of_plane = 12.0;
  double evidence = -1.94;
  double evidence_of_size = 4.62; // a decade of points above the root of all
  double evidence_of_bend = -2.42;
  double max_bend = 5.0;
  double evidence_of_smooth_border = -3.24;
  double evidence_of_open_border = 6.08;
  double common_error_exponent = 0.25;

  // Labels.
  double noises_of_point = 3.0;
  /** \brief A region that is this share of the one it goes into is a part of it, and
   * no scrap: such regions reach as far as their rms, up to max_rms_over_noise. */
  double min_share_of_part = 0.1;
};

inline constexpr PlaceConstants place_constants;

/** \brief A uniform distribution over a width has a variance of width^2 / 12. */
inline constexpr double squared_width_of_variance = 12.0;

/** \brief Logarithms of exact places are finite. */
inline constexpr float least_noise = 1e-12F;

} // namespace pcl_ops::internal
