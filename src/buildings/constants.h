// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>

namespace pcl_ops::internal::buildings {

/** \brief Every number that kinds and plans were tuned with, on simulated rooms and
 * surveys; src/doc/buildings.md says why they are so. Lengths are in meters, areas in
 * square meters, angles in radians. What users choose is in FloorPlanParameters and
 * PlaneRegularizationParameters. */
struct BuildingConstants {
  // Stories.
  /** \brief Planes at so nearly one height are one level. */
  double same_level = 0.15;
  /** \brief A step: what is higher is not the floor. */
  double step = 0.3;
  /** \brief Under a lower ceiling one cannot stand. */
  double headroom = 1.9;
  /** \brief More than the tables of a room have together: the ground. */
  double min_ground_area = 50.0;
  /** \brief Between a ceiling and the floor above it. */
  double max_deck = 0.8;
  /** \brief A level that counts: its area, also as a share of that of the largest. */
  double min_level_area = 1.0;
  double min_level_share = 0.2;
  /** \brief A ceiling covers its room, a flat roof but a small part of the ground. */
  double min_cover_of_floor = 1.0 / 3.0;
  /** \brief Of a plane that says how far down the scene reaches. */
  double min_area_of_depth = 0.3;

  // What a sensor saw, and whether it leans.
  /** \brief Sine of the angle at which a surface is seen, not its edge. */
  double min_sine_of_sight = 0.02;
  /** \brief Of what was seen edge-on from above. */
  double min_drop_below_sensor = 0.1;
  /** \brief A sensor is at most so many times as far away as the planes reach, as
   * turnUnseenUp has it. */
  double max_distance_by_reach = 500.0;
  double min_area_of_leaning_ground = 4.0;
  /** \brief [sr], a hundredth of what is around. */
  double min_sight_of_leaning_ground = 0.1;
  double min_lean = 3.0 * M_PI / 180.0;
  /** \brief A car on a kerb, a lidar on a stick. */
  double max_lean = 12.0 * M_PI / 180.0;
  /** \brief What is more level than the ground: slope as a share of its slope, and what
   * was seen of it as a share of what was seen of the ground. */
  double max_slope_of_level = 0.5;
  double min_sight_of_level = 0.2;

  // Walls.
  /** \brief How far below the ceiling its lower parts and the tops of walls may be. */
  double max_drop_of_ceiling = 0.6;
  double max_gap_above_wall = 0.3;
  /** \brief Of a part of a wall that reaches the ceiling. */
  double min_height_at_ceiling = 0.5;
  double min_wall_width = 1.0;
  /** \brief Counters end there. */
  double min_wall_height = 1.3;
  /** \brief What stands before a wall: cosine of some 25 degrees, and how far before
   * it is, relief of a wall to furniture. */
  double min_cosine_of_front = 0.9;
  double min_before_wall = 0.1;
  double max_before_wall = 1.0;
  /** \brief Samples of a front from its middle to each side, on this share of it. */
  int front_samples = 4;
  double sampled_share_of_front = 0.8;
  /** \brief A part of a wall: cosine of 10 degrees, distance from its plane. */
  double min_cosine_of_part = 0.985;
  double max_off_wall = 0.1;

  // Other kinds.
  double min_area_of_ceiling_part = 0.3;
  /** \brief Of a ceiling without others at its height: below and above cupboards. */
  double min_area_of_low_ceiling = 1.0;
  double min_area_of_high_ceiling = 0.1;
  double high_ceiling = 2.3;
  double min_table_height = 0.3;
  double max_table_height = 1.3;
  double min_table_area = 0.1;
  double max_table_area = 6.0;
  double min_table_width = 0.2;
  double min_ramp_slope = 2.5 * M_PI / 180.0;
  double max_ramp_slope = 35.0 * M_PI / 180.0;
  double min_ramp_area = 0.5;
  double min_ramp_rise = 0.15;
  double max_ramp_above_floor = 0.2;
  double min_roof_area = 2.0;
  double min_step_area = 1.0;
  double min_slab_area = 2.0;
  double same_floor = 0.1;

  // Hills, which are no roofs.
  /** \brief Rms of a roof in units of its noise; with its chimneys. */
  double max_noises_of_roof = 3.0;
  double max_rms_of_roof = 0.35;
  /** \brief Cosine of 60 degrees: steeper planes have no outline from above. */
  double min_cosine_from_above = 0.5;
  /** \brief How far from an outline something is still beside it: eaves reach over the
   * ground, and the foot of a wall has few points. */
  double max_beside_outline = 4.0;
  double min_area_beside_outline = 2.0;
  std::size_t places_of_outline = 32;
  /** \brief What goes on: its height and the cosine of 20 degrees. */
  double same_height = 1.0;
  double min_cosine_of_same_slope = 0.9396926207859084;

  // The cut of a plan.
  /** \brief Of points of the largest floor, for the lowest one. */
  double min_share_of_lowest_floor = 0.2;
  /** \brief Level planes so far below the floor are of its rooms, ceilings so far over
   * the cut. */
  double max_below_floor = 0.6;
  double max_ceiling_over_cut = 6.0;
  /** \brief How far roofs reach beyond walls, and the share of the walls under them of
   * a building seen from outside. */
  double max_eaves = 1.0;
  double min_walls_under_roofs = 0.5;
  /** \brief Points at the height of the cut, that hide gaps. */
  double half_band_of_cloud = 0.1;
  /** \brief The same of walls, at least, and in spacings of their points. */
  double half_band_of_wall = 0.05;
  double spacings_of_band = 3.0;
  /** \brief What hides a wall at the cut is no higher over it; share of the points of
   * the wall between. */
  double max_furniture_over_cut = 1.0;
  double min_share_over_furniture = 0.1;

  // Faces of walls.
  /** \brief Cosine of 4 degrees. */
  double min_cosine_of_parallel = 0.9976;
  /** \brief Gaps up to this, and up to so many spacings, are closed. */
  double max_closed_gap = 0.25;
  double spacings_of_gap = 6.0;
  double edge_of_spacing_cell = 0.25;
  /** \brief Faces on one line; thinner than the recess of a door. */
  double max_off_line = 0.05;
  /** \brief Leaves and panes, set back in gaps: how far, and the share of them that has
   * the wall before it, by squares of at least this edge, so many to a closed gap. */
  double min_recess = 0.02;
  double max_recess = 0.45;
  double max_share_before_leaf = 0.6;
  double min_edge_of_leaf_square = 0.1;
  double squares_of_gap = 3.0;
  /** \brief What noise moves the ends of leaves. */
  double noise_of_ends = 0.02;
  /** \brief Sine of 7 degrees, of what may be a leaf. */
  double max_sine_of_upright = 0.12;
  /** \brief Floors and ceilings beside a wall are looked for around a place beside_wall
   * from its line, within reach_beside_wall: farther than noise moves points, and
   * nearer than the other side of a wall of 10 cm. few_side_squares places tell
   * nothing. */
  double edge_of_side_square = 0.05;
  double beside_wall = 0.06;
  double reach_beside_wall = 0.036;
  std::size_t few_side_squares = 3;

  // Walls and openings of a plan.
  /** \brief Sine of 15 degrees between walls that meet. */
  double min_sine_of_meeting = 0.26;
  /** \brief Share of a wall that has points at the cut. */
  double min_cut_share = 0.25;
  /** \brief Two sides of a wall: cosine of 5 degrees, their distance and how far they
   * are side by side. */
  double max_cosine_of_opposite = -0.996;
  double min_thickness = 0.03;
  double max_thickness = 0.7;
  double min_common_length = 0.3;
  /** \brief Share of an opening at each side that says nothing of sill and head. */
  double margin_of_opening = 0.25;
  /** \brief What hides a gap: how deep it is in the wall, how far before or behind it,
   * and the edge of the bins along it. */
  double max_depth_in_wall = 0.05;
  double max_off_gap = 0.8;
  double edge_of_gap_bin = 0.1;

  // Rooms.
  /** \brief Share of a side that divides rooms, and of the outline of one, that is a
   * wall. */
  double min_walled = 0.5;
  /** \brief A room goes on to a wall over so wide a strip of floor that was not seen.
   */
  double max_unseen = 0.5;
  /** \brief Else it is between the sides of a wall. */
  double min_room_width = 0.35;
  /** \brief Points of floors and ceilings between the sides of a wall, as a share of
   * those elsewhere: what noise moves there. */
  double max_cover_within_wall = 0.5;
  double min_hole_area = 0.02;
  /** \brief Shorter parts of an outline without a wall are not worth a line. */
  double min_unseen_part = 0.05;
  /** \brief Of squares that count once for the height of a floor or a ceiling. */
  double edge_of_height_square = 0.5;
  /** \brief Rooms of an opening: how far from the side of the wall they may begin, and
   * the step at which they are looked for. */
  double max_to_room = 0.3;
  double step_to_room = 0.05;
  /** \brief The highest sill of a door. */
  double max_threshold = 0.25;
  double margin_of_plan = 0.5;
  /** \brief Cells grow with the square of walls. */
  std::size_t max_walls = 1'000;
  /** \brief Squares of what is covered: the edge, their number, and points of each so
   * that where there are points few squares are without. */
  double min_edge_of_cover = 0.1;
  double max_cover_squares = 4e6;
  double points_of_cover_square = 3.0;
  int max_samples_of_cell = 60;

  // Right angles.
  /** \brief Parallel planes are one within so many times the noise of both. */
  double noises_of_offset = 3.0;
};

inline constexpr BuildingConstants constants;

} // namespace pcl_ops::internal::buildings
