// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>

namespace pcl_ops::internal {

/** \brief From what on results are doubtful. Each limit is beyond what ordinary clouds
 * reach, as a warning that is often wrong is no longer read. */
struct WarningConstants {
  // Planes thicker than their surroundings.
  /** \brief An rms of so many noises: what bends or steps within the plane is more than
   * what scatters about it. */
  double thick_noises = 3.0;
  /** \brief Less than this share of the spacing of its points does not show: the road
   * below a lidar of 16 beams bends by a centimeter where points are a decimeter apart.
   */
  double min_rms_of_spacing = 0.125;
  /** \brief Share of the points on planes from which on the result as a whole is thick.
   * Roads that bend have up to 0.62 of those of a lidar scan. */
  double thick_share = 0.65;

  // What is looked at.
  /** \brief Points of a cloud: enough for a share to be right within one per cent, and
   * their tree takes some ten milliseconds. */
  std::size_t sampled_points = 40000;
  /** \brief Of these, whose neighbors are looked up. */
  std::size_t probes = 2000;

  /** \brief Largest step of single precision, over the distance between points. */
  double max_step_of_spacing = 0.25;

  // Planes of rms 0 one behind another.
  /** \brief Scatter over width of what is exact: single precision has seven digits. */
  double max_exact = 1e-5;
  /** \brief A face of a model may have any size; levels of an image have thousands of
   * pixels. */
  double min_points_of_level = 1000;
  /** \brief Two may be the sides of a wall in a model. */
  std::size_t min_levels = 3;
  /** \brief Levels are this near to each other, over their width; stairs are not. */
  double max_step_of_width = 0.1;
  double max_angle_of_levels = 1.0 * (M_PI / 180.0);
  /** \brief Share of the points on planes that have to be on such. */
  double level_share = 0.05;
  /** \brief Voxels of so many steps have the points of several levels: in depth images
   * of a Kinect 5 gave whole walls. */
  double steps_of_voxel = 5.0;

  // Labels that are mixed point by point.
  /** \brief Nearest points that are looked at. */
  std::size_t neighbors_of_label = 8;
  /** \brief Planes at a smaller angle may be one surface [rad]. */
  double max_angle_of_mixed = 15.0 * (M_PI / 180.0);
  /** \brief A point may belong to another plane up to so many times the rms of both. */
  double rms_of_mixed = 2.0;
  /** \brief Share of neighbors on another such plane. The borders of planes alone have
   * up to 0.05. */
  double mixed_share = 0.12;

  // Points on no plane.
  /** \brief Share of the points from which on other values are tried. Woods, furniture
   * and cars have as many; then no value helps, and nothing is said. */
  double none_share = 0.4;
  /** \brief Another value has to put this share of all points on planes that have at
   * least min_plane_share of them. */
  double gained_share = 0.2;
  double min_plane_share = 0.03;
  /** \brief The largest sampling rate that is worth its false planes. */
  double high_sampling_rate = 0.3;
  /** \brief A second search of more points would take seconds. */
  std::size_t max_searched_again = 100000;
  /** \brief Before that, the surroundings of some points on no plane: how many there
   * are, their points, and which share of these must be on planes of each. */
  std::size_t tried_places = 3;
  std::size_t points_of_place = 2000;
  double min_share_of_place = 0.5;

  // Units.
  /** \brief No room or street is a kilometer high; one of meters is 1000 mm or more
   * along all three axes [units of the cloud]. */
  double min_extent_of_millimeters = 1000.0;
  /** \brief Stray points beyond these quantiles do not count. */
  double stray_share = 0.01;
  /** \brief A degree is 111 km; what is less than one wide is seldom this much higher
   * in meters. */
  double max_width_of_degrees = 1.0;
  double min_height_of_width = 200.0;

  // Up.
  /** \brief A floor has this share of all points or more, hardly any below it, and is
   * level within this angle [rad]. */
  double min_floor_share = 0.03;
  double max_share_below_floor = 0.1;
  double max_floor_slope = 15.0 * (M_PI / 180.0);
  /** \brief A depth camera at zero that looks along z has this share of its points
   * within this angle of z, half of the widest view of such cameras [rad]. Without a
   * floor alone, roofs and hills would be doubtful, too. */
  double min_share_ahead = 0.95;
  double max_angle_ahead = 60.0 * (M_PI / 180.0);
};

inline constexpr WarningConstants warning_constants;

} // namespace pcl_ops::internal
