// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "geometry/plane_statistics.h"

#include <cmath>

namespace pcl_ops::internal {

/** \brief Constants of plane detection on neighborhoods, tuned on two clouds of each
 * data set of scripts/accuracy. scripts/ablate varies them: src/doc/places.csv has how
 * far the scores of some data sets move if a constant is halved or doubled.
 * src/doc/decisions.md says what was tried. A place is a distinct point, a support the
 * points around it.
 *
 * A distance threshold of the user replaces noises_of_region and noises_of_point with
 * their terms of bend_of_width; then max_noises_of_plane is not tested. Joins follow
 * the noise in any case. */
struct PlaceConstants {
  // The neighborhoods of places.
  /** \brief A neighborhood has min_neighborhood * (points of the cloud /
   * points_of_min_neighborhood) ^ neighborhood_exponent points, its place included, but
   * not fewer than min_neighborhood and not more than max_neighborhood. Then the factor
   * of \ref neighborhoodSize multiplies the number. Small clouds have small planes and
   * need small neighborhoods. Large clouds need large ones: the beams of a lidar are
   * farther apart than the points along a beam. */
  double min_neighborhood = 10.0;
  double max_neighborhood = 36.0;
  double points_of_min_neighborhood = 400.0;
  double neighborhood_exponent = 0.26;
  /** \brief A place has a support for each level, max_levels at most; that of level 0
   * is the smallest. A support of the next level adds up the supports of its place and
   * of the place's arms: places around it, \ref arms of them at most. These supports
   * overlap, so that their sum counts as only points_per_level times the points of one
   * of them. */
  int max_levels = 6;
  double points_per_level = 3.4;
  static constexpr int arms = 8;
  /** \brief Supports of level 2 and above have at most this share of the points that
   * are searched: a small tile has fewer levels than the whole cloud. */
  double max_share_of_points = 0.1;
  /** \brief For clouds with quantized depth: the search for nearest points scales
   * coordinates along the depth direction by this factor. */
  double depth_scale = 0.25;
  /** \brief A support is flat if its scatter is below max_thickness times its width
   * and it is no line. It is a line if the middle one of its three variances is at most
   * min_slimness times the largest one. Scatter and width are \ref Support::scatter and
   * \ref Support::width. */
  double max_thickness = 0.17 / 3.0; // .057
  double min_slimness = 0.02;

  // The noise of places.
  /** \brief A support is settled if it is so large that its scatter no longer grows
   * with the level. The first settled support of a place is flat, and its scatter is
   * below max_thickening times that of the level before. Larger supports are settled,
   * too, while their scatter is below max_thickening_of_all times that of the first
   * settled one; beyond, the surface bends. */
  double max_thickening = 1.25;
  double max_thickening_of_all = 1.35;
  /** \brief The growth of a level is the scatter of settled supports over that of
   * supports of the level. It is a quantile over the places whose largest settled
   * support is not exact (\ref max_exact_thickness): growth_quantile is the share of
   * these places with less. It counts in full if these places are at least
   * full_share_of_settled of all places; else it is closer to 1. */
  double full_share_of_settled = 0.1;
  double growth_quantile = 0.25;
  /** \brief Largest scatter over width of exact surfaces, such as CAD models. */
  double max_exact_thickness = 0.002;
  /** \brief A support whose scatter, times the growth of its level, is at most
   * share_of_exact * max_exact_thickness times its width is explained by any noise,
   * even 0. For joins over gaps the same share of the width of the joined region is
   * added to the largest distance. */
  double share_of_exact = 0.1;
  /** \brief Limits of the noise of a place, in units of the usual (median) noise of
   * places with its point density. */
  double min_over_usual = 0.7;
  double max_over_usual = 4.0;
  /** \brief Upper limit of the usual noise at a density, in units of the usual noise of
   * the cloud. */
  double max_usual_over_cloud = 3.0;
  /** \brief The usual noise comes from the places whose smallest support is flat, but
   * not exact, if they are at least this share of all places; else from those whose
   * smallest flat support, on any level, is not exact. If the latter places were always
   * used, woods and hills would count, too: in airborne surveys the share of points on
   * thick planes rose from .04 to .15. */
  double min_telling_share = 0.02;
  /** \brief The chosen support of a place is its largest one whose scatter, times the
   * growth of its level, is at most this many times the noise of the place. */
  double max_noises_of_support = 1.8;
  /** \brief Nearest points are in two layers if the variance within the layers is
   * below this share of the total variance. The best division leaves .36 of the
   * variance of a normal distribution, and .25 of that of a uniform distribution. */
  double max_unexplained_by_layers = 0.05;

  // Regions.
  /** \brief Largest distance of a place to the plane of a region that grows, in units
   * of the noise of the place or the rms of the region, whichever is larger. The term
   * of bend_of_width is added. */
  double noises_of_region = 2.5;
  /** \brief The rms of a region counts as at most this many times the noise. */
  double max_rms_over_noise = 2.0;
  /** \brief The noise of a place counts as at most this many times that of its region.
   */
  double max_noise_over_region = 2.0;
  /** \brief Distance to a plane that bending may add to the noise, in units of the
   * width of the region. */
  double bend_of_width = 0.003;
  /** \brief Largest angle between the normal of a place and that of its region [rad].
   */
  double max_angle = 25.0 * (M_PI / 180.0);
  /** \brief A growing region tries to refit its plane once it has more than this many
   * times the points of its last try. */
  double refit_growth = 1.05;

  // Joins.
  /** \brief Largest rms distance of a region to the plane of another one, in units of
   * the noise. The term of bend_of_width is added. For joins over gaps it is the
   * default of MergingParameters::noise_factor. */
  double noises_of_join = 2.0;
  /** \brief Two regions that touch are also joined if they bend little: the rms of
   * their common plane is at most join_bend_of_width times its width, and
   * noises_of_bend times the noise. So the road of lidar64_semkitti_00 has .54 of its
   * points in its largest plane, and .12 if no bend is allowed. Without the second
   * limit the score over all data sets is the same, but hills become one region, and so
   * no plane. */
  double join_bend_of_width = 0.01;
  double noises_of_bend = 8.0;
  /** \brief Largest angle between the planes of regions that touch and are joined
   * [rad]. Not tested if the smaller one has fewer than 24 points. */
  double join_angle = 5.0 * (M_PI / 180.0);
  /** \brief Least share of all border places of a region that touch the region it joins
   * and lie on that region's plane. */
  double min_share_of_border = 0.1;
  /** \brief Largest distance of the centroids of regions that are joined over a gap, in
   * units of the mean of both lengths. */
  double max_gap = 2.0;

  // Planes.
  /** \brief Least number of places of a plane, in units of CloudNoise::common_errors;
   * \ref minPointsFactor multiplies it. */
  double min_independent_points = 6.0;
  /** \brief Least number of flat places of a plane. */
  int min_flat_places = 2;
  /** \brief Largest rms distance of points to their plane, in units of the median noise
   * of its places. At least max_exact_thickness times its width is allowed. */
  double max_noises_of_plane = 12.0;
  /** \brief RegionEvidence::sum: the constant term, and the weight of each member. The
   * bend counts by its natural logarithm. The weights were fitted to labeled clouds for
   * an earlier detector; src/doc/decisions.md says why they stay. */
  double evidence_constant = -1.94;
  double evidence_of_size = 4.62;
  double evidence_of_bend = -2.42;
  double max_bend = 5.0; // largest value of RegionEvidence::bend
  double evidence_of_smooth_border = -3.24;
  double evidence_of_open_border = 6.08;

  // Labels.
  /** \brief Largest distance of a point to its plane, in units of the noise. The term
   * of bend_of_width is added. */
  double noises_of_point = 3.0;
  /** \brief A joined region is a part, not a mere addition, if it has more than this
   * share of the points of the region that takes it. Parts may tilt against each other:
   * if a region has parts, the larger of its noise and its rms counts as its noise, but
   * at most max_rms_over_noise times its noise. */
  double min_share_of_part = 0.1;
};

/** \brief Values made of these are const, not constexpr: scripts/ablate takes the
 * constants from the environment. */
inline constexpr PlaceConstants place_constants;

/** \brief Added to a noise or scatter [m], so that its logarithm, or a quotient by it,
 * is finite for exact points. */
inline constexpr float least_noise = 1e-12F;

} // namespace pcl_ops::internal
