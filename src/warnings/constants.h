// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>

namespace pcl_ops::internal {

/** \brief The limits beyond which results are doubtful. Ordinary clouds do not reach
 * them, because users stop reading a warning that is often wrong. */
struct WarningConstants {
  // Planes thicker than their surroundings.
  /** \brief A thick plane has an rms distance above this many times its noise: it bends
   * or steps more than its points scatter. */
  double thick_noises = 3.0;
  /** \brief A thick plane also has an rms distance above this share of the spacing of
   * its points: the road below a lidar of 16 beams bends by a centimeter where points
   * are a decimeter apart. */
  double min_rms_of_spacing = 0.125;
  /** \brief The warning is given if at least this share of the points on planes is on
   * thick planes. In a lidar scan, roads that bend have a share of up to 0.62. */
  double thick_share = 0.65;

  // Sampling of the cloud.
  /** \brief Number of sampled points: shares are then right within one percent, and the
   * k-d tree takes some ten milliseconds. */
  std::size_t sampled_points = 40000;
  /** \brief Number of sampled points whose neighbors are searched. */
  std::size_t probes = 2000;

  /** \brief Largest step between single precision coordinates, as a share of the
   * spacing of the points. */
  double max_step_of_spacing = 0.25;

  // Planes of rms distance 0 one behind another: the levels of a depth image.
  /** \brief Largest rms distance of an exact plane, as a share of its width: single
   * precision has seven digits. */
  double max_exact = 1e-5;
  /** \brief Fewest points of a level: levels of an image have thousands of pixels, a
   * face of a model may have any number. */
  double min_points_of_level = 1000;
  /** \brief Fewest levels: two planes may be the sides of a wall in a model. */
  std::size_t min_levels = 3;
  /** \brief Levels are nearer to each other than this share of their width; stairs are
   * not. */
  double max_step_of_width = 0.1;
  /** \brief Largest angle between levels [rad]. */
  double max_angle_of_levels = 1.0 * (M_PI / 180.0);
  /** \brief Smallest share of the points on planes that must be on levels. */
  double level_share = 0.05;
  /** \brief Advised voxel size, in steps from level to level: a voxel then holds points
   * of several levels. In depth images of a Kinect 5 steps gave whole walls. */
  double steps_of_voxel = 5.0;

  // Labels that are mixed point by point.
  /** \brief Number of nearest neighbors whose labels are compared. */
  std::size_t neighbors_of_label = 8;
  /** \brief Planes at up to this angle may be one surface [rad]. */
  double max_angle_of_mixed = 15.0 * (M_PI / 180.0);
  /** \brief A point may also belong to another plane if its distance is at most this
   * many times the sum of the rms distances of both planes. */
  double rms_of_mixed = 2.0;
  /** \brief The warning is given if at least this share of the neighbors is on another
   * plane that may be the same surface. Borders of planes alone give up to 0.05. */
  double mixed_share = 0.12;

  // Points on no plane.
  /** \brief Smallest share of points on no plane for which other parameter values are
   * tried. Woods, furniture and cars reach it, too; then no value helps, and no warning
   * is given. */
  double none_share = 0.4;
  /** \brief Another value must put this share of all points on planes in addition.
   * Planes with less than min_plane_share of all points do not count. */
  double gained_share = 0.2;
  double min_plane_share = 0.03;
  /** \brief The sampling rate that is tried and advised; higher ones give false planes.
   */
  double high_sampling_rate = 0.3;
  /** \brief Largest number of finite points for further searches; with more they would
   * take seconds. */
  std::size_t max_searched_again = 100000;
  /** \brief Before the search at high_sampling_rate, small parts of the points on no
   * plane are searched: number of parts, points of a part, and the share of its points
   * that must be on planes in every part. */
  std::size_t searched_parts = 3;
  std::size_t points_of_part = 2000;
  double min_share_of_part = 0.5;

  // Units.
  /** \brief A cloud of at least this extent along all three axes is in millimeters: no
   * room or street is a kilometer high [units of the cloud]. */
  double min_extent_of_millimeters = 1000.0;
  /** \brief Share of points that extents leave out as strays, at either end. */
  double stray_share = 0.01;
  /** \brief x and y are degrees if they extend over less than max_width_of_degrees and
   * the height is above min_height_of_width times that extent. A degree is 111 km; a
   * cloud in meters is seldom so much higher than wide. */
  double max_width_of_degrees = 1.0;
  double min_height_of_width = 200.0;

  // Up.
  /** \brief A floor has at least min_floor_share of all points, at most
   * max_share_below_floor of the points below it, and a slope of at most
   * max_floor_slope [rad]. A point below it is lower by more than rms_below_floor times
   * the rms distance of its points. */
  double min_floor_share = 0.03;
  double max_share_below_floor = 0.1;
  double max_floor_slope = 15.0 * (M_PI / 180.0);
  double rms_below_floor = 3.0;
  /** \brief The view of a depth camera at zero that looks along z: at least
   * min_share_ahead of the points lie within max_angle_ahead of z, half of the widest
   * field of view of depth cameras [rad]. If a missing floor were enough, roofs and
   * hills would be doubtful, too. */
  double min_share_ahead = 0.95;
  double max_angle_ahead = 60.0 * (M_PI / 180.0);
};

inline constexpr WarningConstants warning_constants;

} // namespace pcl_ops::internal
