// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>

namespace pcl_ops::internal {

/** \brief The limits beyond which results are doubtful. Ordinary clouds do not reach
 * them, because users stop reading a warning that is often wrong. Limits without a
 * reason beside them are chosen by hand. */
struct WarningConstants {
  // Planes thicker than their surroundings.
  /** \brief A thick plane has an rms distance of its points above this many times its
   * noise: it bends or steps more than its points scatter. */
  double min_noises_of_thick = 3.0;
  /** \brief A thick plane also has an rms distance above this many times the spacing of
   * its points. A thinner one is no fault: the road below a lidar of 16 beams bends by
   * a centimeter where points are a decimeter apart. */
  double min_spacings_of_thick = 0.125;
  /** \brief The warning is given if at least this share of the points on planes is on
   * thick planes. In a lidar scan, roads that bend have a share of up to 0.62. */
  double min_share_on_thick = 0.65;

  // Sampling of the cloud.
  /** \brief Number of sampled points: shares of the points are then right within one
   * percent, and their k-d tree is built in some ten milliseconds. */
  std::size_t sampled_points = 40000;
  /** \brief Number of sampled points whose neighbors are searched. */
  std::size_t searched_points = 2000;

  // Coordinates in single precision.
  /** \brief Largest step from one number to the next, as a share of the spacing of the
   * points: rounding then moves a point by up to an eighth of the spacing. */
  double max_step_of_spacing = 0.25;

  // Exact planes, those of rms distance 0, one behind another: the levels of a depth
  // image.
  /** \brief Largest rms distance of an exact plane, as a share of its width: above 0,
   * as single precision has seven digits. */
  double max_rms_of_exact = 1e-5;
  /** \brief Smallest number of points of a level: levels of an image have thousands of
   * pixels, a face of a model may have any number. */
  double min_points_of_level = 1000;
  /** \brief Smallest number of levels, because two exact planes may be the sides of a
   * wall in a model. */
  std::size_t min_levels = 3;
  /** \brief The distance between levels is below this share of their width; that of
   * stairs is not. */
  double max_step_of_width = 0.1;
  /** \brief Largest angle between levels [rad]. */
  double max_angle_of_levels = 1.0 * (M_PI / 180.0);
  /** \brief Smallest share of the points on planes that must be on levels. */
  double min_share_on_levels = 0.05;
  /** \brief Advised voxel size, in units of the distance from level to level: a voxel
   * then contains points of several levels. In depth images of a Kinect 5 steps gave
   * whole walls. */
  double steps_of_voxel = 5.0;

  // Labels that are mixed point by point.
  /** \brief Number of nearest neighbors whose labels are compared. */
  std::size_t neighbors_of_label = 8;
  /** \brief Planes at up to this angle may be one surface [rad]. */
  double max_angle_of_mixed = 15.0 * (M_PI / 180.0);
  /** \brief A point may also belong to another plane if its distance to it is at most
   * this many times the sum of the rms distances of both planes. */
  double max_distance_of_mixed = 2.0;
  /** \brief The warning is given if at least this share of the neighbors on planes is
   * on another plane that may be the same surface. Borders of planes alone give shares
   * of up to 0.05. */
  double min_mixed_share = 0.12;

  // Points on no plane.
  /** \brief Smallest share of points on no plane for which other parameter values are
   * tried. Woods, furniture and cars reach it, too; then no value helps, and no warning
   * is given. */
  double min_share_on_none = 0.4;
  /** \brief Smallest share of all points that another value must put on planes in
   * addition. */
  double min_gained_share = 0.2;
  /** \brief Planes with a smaller share of all points than this do not count. */
  double min_plane_share = 0.03;
  /** \brief The sampling rate that is tried and advised; higher ones give false planes.
   */
  double high_sampling_rate = 0.3;
  /** \brief Largest number of finite points for further searches; with more they would
   * take seconds. */
  std::size_t max_searched_again = 100000;
  /** \brief Before the search at high_sampling_rate, so many small parts of the points
   * on no plane are searched. */
  std::size_t searched_parts = 3;
  /** \brief Number of points of such a part. */
  std::size_t points_per_part = 2000;
  /** \brief Smallest share of its points that must be on planes, in every part. */
  double min_share_in_part = 0.5;

  // Units.
  /** \brief A cloud of at least this extent along all three axes is in millimeters: no
   * room or street is a kilometer high [units of the cloud]. */
  double min_extent_of_millimeters = 1000.0;
  /** \brief Share of the coordinates along an axis that its extent leaves out as
   * strays, at either end. */
  double stray_share = 0.01;
  /** \brief x and y that are degrees extend over less than this: a degree is 111 km
   * [units of the cloud]. */
  double max_width_of_degrees = 1.0;
  /** \brief x and y are degrees only if the height is above this many times the width:
   * a cloud in meters is seldom so much higher than wide. */
  double min_height_in_widths = 200.0;

  // The up axis is doubtful if the cloud looks like a depth camera's and has no floor.
  // If a missing floor were enough, it would be doubtful for roofs and hills, too.
  /** \brief Smallest share of all points that a floor has. */
  double min_floor_share = 0.03;
  /** \brief Largest share of all points that are below a floor. */
  double max_share_below_floor = 0.1;
  /** \brief Largest angle between a floor and the horizontal [rad]. */
  double max_floor_slope = 15.0 * (M_PI / 180.0);
  /** \brief A point is below a floor if it is lower by more than this many times the
   * rms distance of the floor's points. */
  double rms_below_floor = 3.0;
  /** \brief Of the view of a depth camera at zero that looks along z: smallest share of
   * the points that are within max_angle_ahead of z. */
  double min_share_ahead = 0.95;
  /** \brief Half of the widest field of view of depth cameras [rad]. */
  double max_angle_ahead = 60.0 * (M_PI / 180.0);
};

inline constexpr WarningConstants warning_constants;

} // namespace pcl_ops::internal
