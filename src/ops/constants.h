// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace pcl_ops::internal {

/** \brief The numbers that scripts/ablate varies of the engine on neighborhoods, tuned
 * on two clouds of each set of scripts/accuracy; src/doc/decisions.md says what was
 * tried, and src/doc/places.csv what each is for: the sets with it halved and doubled.
 */
struct PlaceConstants {
  // The neighborhoods of places.
  /** \brief A neighborhood has min_neighbors * (points / neighbors_cloud) ^
   * neighbors_growth points, its place included, but not fewer than min_neighbors and
   * not more than max_neighbors. Small clouds have small planes and need small ones; in
   * large ones the beams of a lidar are farther apart than the points along a beam. */
  double min_neighbors = 10.0;
  double max_neighbors = 36.0;
  double neighbors_cloud = 400.0;
  double neighbors_growth = 0.26;
  /** \brief The supports of a place are numbered by level, from the smallest: each has
   * points_per_level times the points of the one before. It adds up the supports before
   * of the place and of its arms, so many places around it; these overlap. */
  int max_levels = 6;
  double points_per_level = 3.4;
  static constexpr int arms = 8;
  /** \brief Supports from the third level on have at most this share of the points. */
  double max_share_of_points = 0.1;
  /** \brief Where depth is quantized: distances along the direction of depth count as
   * this share of themselves while nearest points are looked for. */
  double depth_of_levels = 0.25;
  /** \brief A support is flat if its scatter is below max_thickness times its width,
   * and its variance in the narrower direction of its plane is above min_slimness times
   * that in the longer one: else it is a line. */
  double max_thickness = 0.17 / 3.0;
  double min_slimness = 0.02;

  // The noise of places.
  /** \brief A support is settled if it scatters by less than max_thickening times the
   * one before. Larger supports are, too, while they scatter by less than
   * max_thickening_of_all times the first settled one; from there on the surface bends.
   */
  double max_thickening = 1.25;
  double max_thickening_of_all = 1.35;
  /** \brief How much the scatter of supports grows until they are settled: this
   * quantile over the places with a settled support. It counts in full where these are
   * at least this share of all places. */
  double share_of_level_places = 0.1;
  double growth_quantile = 0.25;
  /** \brief Largest scatter over width of what is exact, as CAD models are. */
  double max_exact = 0.002;
  /** \brief Scatter of a support, and distance of a region to the plane of another one,
   * that count as exact, in units of max_exact times their width. */
  double share_of_exact = 0.1;
  /** \brief Limits of the noise of a place, in units of what is usual where points are
   * as dense; and the limit of the latter, in units of what is usual in the cloud. */
  double min_over_usual = 0.7;
  double max_over_usual = 4.0;
  double max_usual_over_cloud = 3.0;
  /** \brief Only places whose smallest supports are flat say what noise is usual, if
   * they are at least this share of all; else those with a flat support of any size. If
   * the latter always did, woods and hills would, too: in airborne surveys the share of
   * points on thick planes rose from .04 to .15. */
  double min_telling_share = 0.02;
  /** \brief A place looks at its largest support that scatters by no more than this
   * many noises. */
  double max_noises_of_support = 1.8;
  /** \brief Nearest points are in two layers if the variance about the mean of their
   * own layer is at most this share of the variance about the mean of all. The best
   * division leaves .36 of it in white noise, and .25 where distances are spread
   * evenly. */
  double max_rest_of_layers = 0.05;

  // Regions.
  /** \brief Largest distance of a place to the plane of its region, in units of the
   * larger of noise and rms of the region. */
  double noises_of_region = 2.5;
  /** \brief The rms counts as at most this many noises. */
  double max_rms_over_noise = 2.0;
  /** \brief The noise of a place counts as at most this many times that of its region.
   */
  double max_noise_over_region = 2.0;
  /** \brief What surfaces may bend by beside their noise, in units of the width of the
   * region. */
  double bend_of_width = 0.003;
  double max_angle = 25.0 * (M_PI / 180.0); // of a place's normal to that of its region
  double refit_growth = 1.05; // of the number of points, from one fit to the next

  // Joins.
  int join_rounds = 6;
  /** \brief Largest rms distance of a region to the plane of another one, in units of
   * the noise; over gaps, too. */
  double noises_of_join = 2.0;
  /** \brief Two regions together may also bend: the rms of their common plane is at
   * most this share of its width, and at most so many noises. With both limits the road
   * of lidar64_semkitti_00 has .54 of its points in its largest plane, .12 where no
   * bend is allowed; without the second limit hills become one region, and so no plane.
   * The number of all sets is the same. */
  double join_bend_of_width = 0.01;
  double noises_of_bend = 8.0;
  double join_angle = 5.0 * (M_PI / 180.0);
  /** \brief Border places of a region that lie on the plane of the region it joins: the
   * least share of all its border places, and of those at the border of both. */
  double min_share_of_border = 0.1;
  double min_fitting_border = 0.5;
  double max_gap = 2.0; // distance of the centers over the mean of both lengths

  // Evidence for a region, a sum (RegionEvidence): above 0 it is a plane.
  double min_independent_points = 6.0; // times the points that err alike
  int min_flat_places = 2;
  /** \brief Largest rms of a plane in units of its noise. */
  double max_noises_of_plane = 12.0;
  double evidence = -1.94;
  double evidence_of_size = 4.62;  // for each decade of points above the root of all
  double evidence_of_bend = -2.42; // times the natural logarithm of the bend
  double max_bend = 5.0;
  double evidence_of_smooth_border = -3.24;
  double evidence_of_open_border = 6.08;
  double common_error_exponent = 0.25; // of common_errors, points count less by it

  // Labels.
  double noises_of_point = 3.0; // largest distance of a point to its plane
  /** \brief A region of more points than this share of those of the one it joins is a
   * part of it, and no scrap. What has such parts reaches as far as its rms, up to
   * max_rms_over_noise: its parts may lean away from each other. */
  double min_share_of_part = 0.1;
};

inline constexpr PlaceConstants place_constants;

/** \brief A uniform distribution over a width has a variance of width^2 / 12. */
inline constexpr double squared_width_of_variance = 12.0;

/** \brief [m], so that logarithms of exact places, and what is divided by their noise,
 * are finite. */
inline constexpr float least_noise = 1e-12F;

} // namespace pcl_ops::internal
