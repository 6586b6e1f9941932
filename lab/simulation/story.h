// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulated_cloud.h"

#include <set>
#include <utility>
#include <vector>

namespace pcl_ops::simulation {

/** Properties of a scanned story of a building that make its floor plan hard to find.
 */
struct StoryHardship {
  /** Share of each wall's length that cupboards of 0.7 to 2 m height hide, where there
   * is room for them. */
  double furnished = 0.0;
  /** Whether each wall between two rooms that is long enough has a glass pane instead
   * of a door. A pane is 1.5 to 2.5 m wide and ends 0.1 m below the ceiling. Rays pass
   * it. */
  bool has_glass = false;
  /** Share of the length of each wall face without readings, as of a mirror or a black
   * surface. Rays go on to what is behind it. */
  double missing = 0.0;
  /** Number of boxes and balls on the floor of each room. */
  int clutter = 0;
  bool has_ceiling = true;
  /** Standard deviation of the error of each coordinate of a point [m]. */
  double noise = 0.003;
  /** Error that the way from one scan position to the next adds to the position, as a
   * share of the length of that way. */
  double drift = 0.0;
};

/** Rooms between walls of 8 to 24 cm, with doors between most neighbors and windows in
 * the outer walls, scanned from a tripod in each room; z is up, the floor is at 0. */
struct Story {
  /** The rectangle between the wall faces of each room, before the turn by yaw [m]. */
  std::vector<Eigen::AlignedBox2d> rooms;
  /** Index pairs of rooms with a door or a pane between them, the smaller one first. */
  std::set<std::pair<std::size_t, std::size_t>> doors;
  /** Rotation of the rooms about the origin in the cloud's frame [rad]. */
  double yaw = 0.0;
  /** All labels are 0. */
  LabeledCloud cloud;
};

/** Draws the rooms of a story and scans them. */
Story
makeStory (Seed seed, const StoryHardship& hardship);

} // namespace pcl_ops::simulation
