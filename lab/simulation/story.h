// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulated_cloud.h"

#include <set>
#include <utility>
#include <vector>

namespace pcl_ops::simulation {

/** What makes a story hard to draw a plan of. */
struct StoryHardship {
  /** Share of each wall with cupboards before it, 0.7 to 2 m high. */
  double furnished = 0.0;
  /** Whether the wall between two rooms has a pane from floor to ceiling, which no
   * sensor sees, 1.5 to 2.5 m wide. */
  bool has_glass = false;
  /** Share of each wall that gives no reading, as mirrors and black paint. */
  double missing = 0.0;
  /** Boxes and balls that lie about in each room. */
  int clutter = 0;
  bool has_ceiling = true;
  /** Standard deviation of each coordinate [m]. */
  double noise = 0.003;
  /** How wrong the next position is, over its distance from the one before. */
  double drift = 0.0;
};

/** Rooms between walls of 8 to 24 cm, with doors between most neighbors and windows in
 * the outer walls, scanned from a tripod in each room; z is up, the floor is at 0. */
struct Story {
  /** Between the faces of their walls. */
  std::vector<Eigen::AlignedBox2d> rooms;
  /** Pairs of rooms with a door or a pane between them, each with the smaller first. */
  std::set<std::pair<std::size_t, std::size_t>> doors;
  /** Of the rooms against the x axis of the cloud, about the origin [rad]. */
  double yaw = 0.0;
  LabeledCloud cloud;
};

Story
makeStory (Seed seed, const StoryHardship& hardship);

} // namespace pcl_ops::simulation
