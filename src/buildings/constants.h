// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>

namespace pcl_ops::internal::buildings {

/** \brief Constants of plane kinds, floor plans and right angles; src/doc/buildings.md
 * has the rules that use them. Numbers without a reason beside them are chosen by hand,
 * on simulated rooms and surveys. Tests of limits (test/buildings) show from both sides
 * what many of them decide. Lengths are in meters, areas in square meters, angles in
 * radians. Parameters that users choose are in FloorPlanParameters and
 * PlaneRegularizationParameters. */
struct BuildingConstants {
  // Stories.
  /** \brief Level planes whose heights differ by at most this are one level. */
  double same_level = 0.15;
  /** \brief Largest height of a step: a higher surface is no part of the floor. */
  double max_step = 0.3;
  /** \brief Smallest height of a ceiling over its floor, so that one can stand. */
  double headroom = 1.9;
  /** \brief Smallest area of a level that is surely ground: all tables of a room
   * together have less. */
  double min_ground_area = 50.0;
  /** \brief Largest height between a ceiling and the floor above it. */
  double max_deck_thickness = 0.8;
  /** \brief Smallest area of a level that makes a story. */
  double min_level_area = 1.0;
  /** \brief The same as a share of the area of the largest level. */
  double min_share_of_largest_level = 0.2;
  /** \brief Smallest area of a highest level that is a ceiling, as a share of the area
   * of the floor below. A ceiling covers its room, a flat roof only a small part of the
   * ground. */
  double min_ceiling_share_of_floor = 1.0 / 3.0;
  /** \brief Smaller planes do not count for the lowest height of a scene. */
  double min_area_of_lowest_plane = 0.3;

  // What a sensor saw, and whether it leans.
  /** \brief Sine of the angle between a plane and the ray from its centroid to the
   * sensor: at this or less the sensor saw the plane edge-on. */
  double max_sine_of_edge_on = 0.02;
  /** \brief A plane seen edge-on counts as seen from above if it is lower than the
   * sensor by more than this. */
  double min_drop_below_sensor = 0.1;
  /** \brief A viewpoint farther from the planes than so many times the size of the
   * scene is no sensor. */
  double max_distance_by_size = 500.0;
  /** \brief Smallest area of the ground under a sensor that leans. */
  double min_area_of_leaning_ground = 4.0;
  /** \brief Smallest solid angle [sr] that this ground fills, about a hundredth of the
   * full sphere. */
  double min_solid_angle_of_leaning_ground = 0.1;
  /** \brief Smallest slope of this ground: below 3 degrees the lean does not matter. */
  double min_lean = 3.0 * M_PI / 180.0;
  /** \brief Largest slope of this ground: a car on a curb or a lidar on a stick leans
   * by up to 12 degrees. */
  double max_lean = 12.0 * M_PI / 180.0;
  /** \brief A plane shows that the sensor does not lean if its slope is at most the
   * first share of the slope of this ground, and its solid angle at least the second
   * share of the solid angle of this ground. */
  double max_slope_share_of_level_plane = 0.5;
  double min_solid_angle_share_of_level_plane = 0.2;

  // Walls.
  /** \brief Largest distance of lower parts of a ceiling below its level, if they face
   * down; other parts may be lower by same_level. */
  double max_drop_of_ceiling = 0.6;
  /** \brief Largest gap between the top of a wall or of a sloping roof and the ceiling.
   */
  double max_gap_above_wall = 0.3;
  /** \brief Smallest height of a part of a wall that reaches the ceiling. */
  double min_height_at_ceiling = 0.5;
  /** \brief Smallest width of a wall that does not reach a ceiling. */
  double min_wall_width = 1.0;
  /** \brief Smallest height of a wall that does not reach a ceiling; counters are
   * lower.
   */
  double min_wall_height = 1.3;
  /** \brief Smallest cosine of the angle between the normals of a front of furniture
   * and of the wall behind it: some 25 degrees. */
  double min_cosine_of_front = 0.9;
  /** \brief Smallest distance of a front from the wall behind it; nearer planes are
   * relief of the wall. */
  double min_before_wall = 0.1;
  /** \brief Largest distance of a front from the wall behind it. */
  double max_before_wall = 1.0;
  /** \brief Samples on a front lie on a grid, with so many steps from its middle to
   * each side. */
  int steps_to_side_of_front = 4;
  /** \brief Share of the length and of the width of a front that this grid spans. */
  double sampled_share_of_front = 0.8;
  /** \brief Points of a wall or a ceiling are above the top of a front, or of a wall,
   * if they are higher by more than this. */
  double min_above_top = 0.15;
  /** \brief Smallest cosine of the angle between the normals of a wall and of a part of
   * it: 10 degrees. In a plan, fronts of furniture and the walls behind them have at
   * most this angle, too. */
  double min_cosine_of_part = 0.985;
  /** \brief Largest distance of a part of a wall from the plane of the wall. */
  double max_off_wall = 0.1;

  // Other kinds.
  /** \brief Smallest area of a part of a ceiling in a story with a ceiling level. */
  double min_area_of_ceiling_part = 0.3;
  /** \brief Smallest areas of a ceiling in a story without a ceiling level: of one
   * lower than high_ceiling over the floor, which cupboards reach, and of a higher one.
   */
  double min_area_of_low_ceiling = 1.0;
  double min_area_of_high_ceiling = 0.1;
  double high_ceiling = 2.3;
  /** \brief Tables: their height over the floor, area and width. */
  double min_table_height = 0.3;
  double max_table_height = 1.3;
  double min_table_area = 0.1;
  double max_table_area = 6.0;
  double min_table_width = 0.2;
  /** \brief Ramps: their slope, their area, the height from their lower to their upper
   * end, and the height between their lower end and the floor. */
  double min_ramp_slope = 2.5 * M_PI / 180.0;
  double max_ramp_slope = 35.0 * M_PI / 180.0;
  double min_ramp_area = 0.5;
  double min_ramp_rise = 0.15;
  double max_ramp_off_floor = 0.2;
  /** \brief Smallest area of a sloping roof. */
  double min_roof_area = 2.0;
  /** \brief A level plane of any area is floor if it is less than this above the level
   * of the floor. */
  double same_floor = 0.1;
  /** \brief Smallest area of a level plane that is floor up to max_step above the level
   * of the floor. */
  double min_step_area = 1.0;
  /** \brief Smallest area of a slab, of a level roof, or of ground above max_step. */
  double min_slab_area = 2.0;

  // Hills, which are no roofs.
  /** \brief Largest rms distance of the points of a roof to its plane, chimneys
   * included, as a multiple of its noise. */
  double max_noises_of_roof = 3.0;
  /** \brief The same in meters. */
  double max_rms_of_roof = 0.35;
  /** \brief Cosine of 60 degrees: steeper planes have no outline from above. */
  double min_cosine_from_above = 0.5;
  /** \brief Largest horizontal distance of planes beside an outline: eaves reach over
   * the ground, and the foot of a wall has few points. */
  double max_beside_outline = 4.0;
  /** \brief Smallest area of planes that count beside an outline. */
  double min_area_beside_outline = 2.0;
  /** \brief Number of samples along an outline, but for rounding it to whole numbers on
   * each side. */
  std::size_t samples_of_outline = 32;
  /** \brief A plane continues another one if their heights differ by less than
   * same_height, and their normals by less than 20 degrees, which has this cosine. */
  double same_height = 1.0;
  double min_cosine_of_same_slope = 0.9396926207859084;

  // The cut of a plan.
  /** \brief Smallest number of points of the lowest floor, as a share of those of the
   * largest floor. */
  double min_share_of_largest_floor = 0.2;
  /** \brief Level planes at the cut or lower, but less than this below the floor, are
   * in the rooms at the cut. */
  double max_below_floor = 0.6;
  /** \brief Ceilings less than this above the cut are over the rooms at the cut, except
   * where they are over the floor of a story above, or over a lower ceiling. */
  double max_ceiling_over_cut = 6.0;
  /** \brief How far the roofs of a building seen from outside reach beyond its walls.
   */
  double max_eaves = 1.0;
  /** \brief Smallest share of all wall points that is under the roofs of a building. */
  double min_walls_under_roofs = 0.5;
  /** \brief Points of the cloud within this height of the cut may hide gaps of walls.
   */
  double half_band_of_cloud = 0.1;
  /** \brief Wall points within this height of the cut are at the cut, or within
   * spacings_of_band times their spacing if that is more. */
  double half_band_of_wall = 0.05;
  double spacings_of_band = 3.0;
  /** \brief Largest height above the cut of furniture that hides a wall. */
  double max_furniture_over_cut = 1.0;
  /** \brief Smallest share of the points of a wall that is higher than
   * half_band_of_cloud and lower than max_furniture_over_cut above the cut, if the wall
   * is seen over furniture. */
  double min_share_over_furniture = 0.1;

  // Faces of walls.
  /** \brief Cosine of 4 degrees, the largest angle between parallel faces. */
  double min_cosine_of_parallel = 0.9976;
  /** \brief Gaps of a face are closed up to this length, or up to spacings_of_gap times
   * the spacing of its points if that is more. */
  double max_closed_gap = 0.25;
  double spacings_of_gap = 6.0;
  /** \brief Edge of the squares of the grid by which that spacing is measured. */
  double edge_of_spacing_square = 0.25;
  /** \brief Largest distance of faces on one line. A leaf that is a wall by its kind
   * and set back by less is a part of its wall, unless the wall surrounds it. */
  double max_off_line = 0.05;
  /** \brief How far door leaves and window panes are set back behind the face of the
   * wall. */
  double min_recess = 0.02;
  double max_recess = 0.45;
  /** \brief Largest share of a leaf that has wall points in front of it. It is counted
   * in squares of a grid. */
  double max_share_before_leaf = 0.6;
  /** \brief Smallest edge of these squares. */
  double min_edge_of_leaf_square = 0.1;
  /** \brief The longest gap between neighboring points is at most so many squares long.
   */
  double squares_of_gap = 3.0;
  /** \brief How far noise moves the ends of leaves. */
  double noise_of_ends = 0.02;
  /** \brief Sine of 7 degrees, the largest lean of a plane that may be a leaf. */
  double max_sine_of_upright = 0.12;
  /** \brief Points of floors and ceilings beside a wall are searched around samples,
   * one for each square of this edge that has points of the wall. */
  double edge_of_side_square = 0.05;
  /** \brief Distance of these samples from the line of the wall. */
  double beside_wall = 0.06;
  /** \brief Largest horizontal distance of a point from its sample. The nearest and the
   * farthest points, 0.024 and 0.096 from the line, are farther than noise moves
   * points, and nearer than the other side of a wall of 10 cm. */
  double reach_beside_wall = 0.036;
  /** \brief Up to so many samples with points beside them prove nothing. */
  std::size_t few_samples_beside_wall = 3;

  // Walls and openings of a plan.
  /** \brief Sine of 15 degrees, the smallest angle between walls that meet. */
  double min_sine_of_meeting = 0.26;
  /** \brief A wall is hidden at the cut unless more than this share of its length has
   * points there. */
  double min_share_at_cut = 0.25;
  /** \brief Largest cosine of the angle between the directions of the two sides of a
   * wall: 5 degrees from opposite. */
  double max_cosine_of_opposite = -0.996;
  /** \brief Smallest and largest distance between the two sides of a wall. */
  double min_thickness = 0.03;
  double max_thickness = 0.7;
  /** \brief Smallest length over which the two sides of a wall are side by side. */
  double min_common_length = 0.3;
  /** \brief Share of the width of an opening that is ignored at each end for sill and
   * head. */
  double margin_of_opening = 0.25;
  /** \brief Points less deep than this behind the front of a wall are in front of a gap
   * or in it: they hide it. Deeper points are seen through the gap. */
  double max_depth_of_hiding = 0.05;
  /** \brief Points farther than this before or behind a gap do not count. */
  double max_off_gap = 0.8;
  /** \brief Length of the bins along a gap in which points are counted. */
  double length_of_gap_bin = 0.1;

  // Rooms.
  /** \brief Smallest share of walls in a side of a cell that divides rooms, in the
   * outline of a room, and in the border of a cell within a wall. */
  double min_walled_share = 0.5;
  /** \brief A room extends to a wall over a strip of unseen floor up to this wide. */
  double max_unseen = 0.5;
  /** \brief A narrower area lies between the two sides of a wall, or is no room. */
  double min_room_width = 0.35;
  /** \brief Largest density of floor and ceiling points between the two sides of a
   * wall, as a share of their mean density in the plan, or of that on the denser side
   * if it is less. Noise moves that many points there. */
  double max_density_share_within_wall = 0.5;
  /** \brief Smallest area of a hole of a room. */
  double min_hole_area = 0.02;
  /** \brief Shorter parts of an outline without a wall are left out. */
  double min_unseen_part = 0.05;
  /** \brief Edge of the squares of a grid each of which counts once for the height of a
   * floor or a ceiling. What is in one of these squares, or next to it, is over the
   * floors in it. */
  double edge_of_height_square = 0.5;
  /** \brief The rooms of an opening are searched up to max_to_room from the side of the
   * wall, in steps of step_to_room. */
  double max_to_room = 0.3;
  double step_to_room = 0.05;
  /** \brief A sill lower than this is the threshold of a door. */
  double max_threshold = 0.25;
  /** \brief Distance of the rim of a plan from the outermost walls. An outermost end of
   * a wall is free if no other wall passes through it or ends nearer to it than this.
   */
  double margin_of_plan = 0.5;
  /** \brief A plan with more walls gets no rooms: the number of cells grows with the
   * square of the number of walls. */
  std::size_t max_walls = 1'000;
  /** \brief Smallest edge of the squares of the grid that counts the points of floors,
   * ceilings or roofs. */
  double min_edge_of_cover_square = 0.1;
  /** \brief Largest number of these squares. */
  double max_cover_squares = 4e6;
  /** \brief Mean number of points of a covered square. If the points are independent,
   * the share e^-3 of such squares is empty, 5 %. */
  double points_of_cover_square = 3.0;
  /** \brief An empty square is covered, too, among points that are farther apart than
   * the edge of a square, as in a room that was scanned more sparsely than the rest of
   * the plan. Of the squares around it, up to so many to each side, at least
   * min_share_of_sparse_squares have points there, fewer than
   * max_points_of_sparse_square on average. At the border of a dense floor they have
   * more points, or fewer of them have any. */
  std::ptrdiff_t sparse_squares_to_side = 3;
  double min_share_of_sparse_squares = 0.2;
  double max_points_of_sparse_square = 1.5;
  /** \brief Largest number of samples of a cell in each direction, for the share of the
   * cell that is covered. */
  int max_samples_of_cell = 60;

  // Right angles.
  /** \brief Parallel planes are coplanar within this multiple of their joint rms
   * distance, the root of the sum of both squares. */
  double rms_of_offset = 3.0;
};

inline constexpr BuildingConstants constants;

} // namespace pcl_ops::internal::buildings
