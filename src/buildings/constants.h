// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>

namespace pcl_ops::internal::buildings {

/** \brief Constants of plane kinds, floor plans and right angles, tuned on simulated
 * rooms and surveys; src/doc/buildings.md has the rules that use them. Lengths are in
 * meters, areas in square meters, angles in radians. Parameters that users choose are
 * in FloorPlanParameters and PlaneRegularizationParameters. */
struct BuildingConstants {
  // Stories.
  /** \brief Level planes within this height difference are one level. Points of walls
   * and ceilings are above the top of a front or a wall if they are higher by more than
   * this. */
  double same_level = 0.15;
  /** \brief Height of a step: a surface higher above the floor is no part of the floor.
   */
  double step = 0.3;
  /** \brief Smallest height of a ceiling over its floor, so that one can stand. */
  double headroom = 1.9;
  /** \brief Smallest area of ground: all tables of a room together have less. */
  double min_ground_area = 50.0;
  /** \brief Largest height between a ceiling and the floor above it. */
  double max_deck = 0.8;
  /** \brief Smallest area of a level that makes a story: in square meters, and as a
   * share of the area of the largest level. */
  double min_level_area = 1.0;
  double min_level_share = 0.2;
  /** \brief Smallest area of a highest level that is a ceiling, as a share of the floor
   * below. A ceiling covers its room, a flat roof only a small part of the ground. */
  double min_cover_of_floor = 1.0 / 3.0;
  /** \brief Smallest area of a plane that may be the lowest one of the scene. */
  double min_area_of_depth = 0.3;

  // What a sensor saw, and whether it leans.
  /** \brief Sine of the angle between ray and plane: at less the plane is edge-on. */
  double min_sine_of_sight = 0.02;
  /** \brief A plane seen edge-on counts as seen from above if it is lower by this. */
  double min_drop_below_sensor = 0.1;
  /** \brief A viewpoint farther away than so many times the reach of the planes is no
   * sensor, as in turnUnseenUp. */
  double max_distance_by_reach = 500.0;
  /** \brief Ground under a sensor that leans: its smallest area, its smallest solid
   * angle [sr], about a hundredth of the full sphere, and its slopes, from a lean that
   * matters up to that of a car on a curb or a lidar on a stick. */
  double min_area_of_leaning_ground = 4.0;
  double min_sight_of_leaning_ground = 0.1;
  double min_lean = 3.0 * M_PI / 180.0;
  double max_lean = 12.0 * M_PI / 180.0;
  /** \brief A plane that is more level than this ground, so that the sensor does not
   * lean: its largest slope and smallest solid angle, as shares of those of the ground.
   */
  double max_slope_of_level = 0.5;
  double min_sight_of_level = 0.2;

  // Walls.
  /** \brief Largest distance of lower parts of a ceiling below its level, if they face
   * down; other parts may be lower by same_level. */
  double max_drop_of_ceiling = 0.6;
  /** \brief Largest gap between the top of a wall or of a sloping roof and the ceiling.
   */
  double max_gap_above_wall = 0.3;
  /** \brief Smallest height of a part of a wall that reaches the ceiling. */
  double min_height_at_ceiling = 0.5;
  /** \brief Smallest width and height of a wall that does not reach a ceiling; counters
   * are lower. */
  double min_wall_width = 1.0;
  double min_wall_height = 1.3;
  /** \brief A front of furniture before a wall: cosine of some 25 degrees between their
   * normals, and its distance. Nearer planes are relief of the wall. */
  double min_cosine_of_front = 0.9;
  double min_before_wall = 0.1;
  double max_before_wall = 1.0;
  /** \brief Grid of samples on a front: their number from its middle to each side, and
   * the share of its length and width that they span. */
  int front_samples = 4;
  double sampled_share_of_front = 0.8;
  /** \brief A part of a wall: cosine of 10 degrees between their normals, and largest
   * distance from the plane of the wall. In a plan, fronts of furniture and their walls
   * have at most this angle, too. */
  double min_cosine_of_part = 0.985;
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
  /** \brief Tables; heights are over the floor. */
  double min_table_height = 0.3;
  double max_table_height = 1.3;
  double min_table_area = 0.1;
  double max_table_area = 6.0;
  double min_table_width = 0.2;
  /** \brief Ramps: their slope, area and rise, and how far their lower end may be from
   * the height of the floor. */
  double min_ramp_slope = 2.5 * M_PI / 180.0;
  double max_ramp_slope = 35.0 * M_PI / 180.0;
  double min_ramp_area = 0.5;
  double min_ramp_rise = 0.15;
  double max_ramp_off_floor = 0.2;
  double min_roof_area = 2.0; // of a sloping roof
  /** \brief A level plane is floor if it is less than same_floor above the level of the
   * floor, or less than a step and of min_step_area or more. */
  double same_floor = 0.1;
  double min_step_area = 1.0;
  /** \brief Smaller level planes above a step are no slab, roof or ground. */
  double min_slab_area = 2.0;

  // Hills, which are no roofs.
  /** \brief Largest rms distance of a roof, chimneys included: as a multiple of its
   * noise, and in meters. */
  double max_noises_of_roof = 3.0;
  double max_rms_of_roof = 0.35;
  /** \brief Cosine of 60 degrees: steeper planes have no outline from above. */
  double min_cosine_from_above = 0.5;
  /** \brief Largest horizontal distance of planes beside an outline: eaves reach over
   * the ground, and the foot of a wall has few points. */
  double max_beside_outline = 4.0;
  /** \brief Smaller planes beside an outline do not count. */
  double min_area_beside_outline = 2.0;
  /** \brief Number of samples along an outline. */
  std::size_t samples_of_outline = 32;
  /** \brief A plane that continues another: largest height difference, and cosine of 20
   * degrees between their normals. */
  double same_height = 1.0;
  double min_cosine_of_same_slope = 0.9396926207859084;

  // The cut of a plan.
  /** \brief Fewest points of the lowest floor, as a share of those of the largest. */
  double min_share_of_lowest_floor = 0.2;
  /** \brief Level planes less than this below the floor, and ceilings less than this
   * above the cut, belong to its rooms. */
  double max_below_floor = 0.6;
  double max_ceiling_over_cut = 6.0;
  /** \brief A building seen from outside: how far its roofs reach beyond its walls, and
   * the smallest share of wall points under roofs. */
  double max_eaves = 1.0;
  double min_walls_under_roofs = 0.5;
  /** \brief Points within this height of the cut may hide gaps. */
  double half_band_of_cloud = 0.1;
  /** \brief Wall points within this height of the cut are cut: the larger one of a
   * length and a multiple of their spacing. */
  double half_band_of_wall = 0.05;
  double spacings_of_band = 3.0;
  /** \brief Largest height above the cut of furniture that hides a wall, and smallest
   * share of the wall's points from half_band_of_cloud above the cut to this height. */
  double max_furniture_over_cut = 1.0;
  double min_share_over_furniture = 0.1;

  // Faces of walls.
  /** \brief Cosine of 4 degrees between parallel faces. */
  double min_cosine_of_parallel = 0.9976;
  /** \brief Gaps of a face up to max_closed_gap or spacings_of_gap times its point
   * spacing are closed, whichever is longer. The spacing is measured on a grid whose
   * cells have edge_of_spacing_cell. */
  double max_closed_gap = 0.25;
  double spacings_of_gap = 6.0;
  double edge_of_spacing_cell = 0.25;
  /** \brief Largest distance of faces on one line; less than the recess of a door. */
  double max_off_line = 0.05;
  /** \brief Door leaves and window panes: how far they are set back, and how much of
   * them may have wall points in front. That share is counted in grid squares: their
   * smallest edge, and how many of them the longest gap between neighboring points has.
   */
  double min_recess = 0.02;
  double max_recess = 0.45;
  double max_share_before_leaf = 0.6;
  double min_edge_of_leaf_square = 0.1;
  double squares_of_gap = 3.0;
  /** \brief How far noise moves the ends of leaves. */
  double noise_of_ends = 0.02;
  /** \brief Sine of 7 degrees, the largest lean of a plane that may be a leaf. */
  double max_sine_of_upright = 0.12;
  /** \brief Points of floors and ceilings beside a wall are searched around samples,
   * one for each square along the wall that has points: within reach_beside_wall of a
   * sample at distance beside_wall from the line of the wall. This is farther than
   * noise moves points, and nearer than the other side of a wall of 10 cm. Up to
   * few_side_squares samples with such points prove nothing. */
  double edge_of_side_square = 0.05;
  double beside_wall = 0.06;
  double reach_beside_wall = 0.036;
  std::size_t few_side_squares = 3;

  // Walls and openings of a plan.
  /** \brief Sine of 15 degrees, the smallest angle between walls that meet. */
  double min_sine_of_meeting = 0.26;
  /** \brief A wall is hidden at the cut unless more of its length has points there. */
  double min_cut_share = 0.25;
  /** \brief Two sides of one wall: largest cosine of the angle between their
   * directions, 5 degrees from opposite; their distance; the length over which they are
   * side by side. */
  double max_cosine_of_opposite = -0.996;
  double min_thickness = 0.03;
  double max_thickness = 0.7;
  double min_common_length = 0.3;
  /** \brief Share of an opening's width ignored at each end for sill and head. */
  double margin_of_opening = 0.25;
  /** \brief Points at a gap: how deep in the wall they still hide it, how far before or
   * behind the wall they count, and the length of bins along the gap. */
  double max_depth_in_wall = 0.05;
  double max_off_gap = 0.8;
  double edge_of_gap_bin = 0.1;

  // Rooms.
  /** \brief Smallest share of walls in a side of a cell that divides rooms, in the
   * outline of a room, and in the border of a cell within a wall. */
  double min_walled = 0.5;
  /** \brief A room extends to a wall over a strip of unseen floor up to this wide. */
  double max_unseen = 0.5;
  /** \brief A narrower area lies between the two sides of a wall. */
  double min_room_width = 0.35;
  /** \brief Density of floor and ceiling points between the sides of a wall, as a share
   * of their mean density. Noise moves that many points there. */
  double max_cover_within_wall = 0.5;
  /** \brief Smallest area of a hole of a room. */
  double min_hole_area = 0.02;
  /** \brief Shorter parts of an outline without a wall are left out. */
  double min_unseen_part = 0.05;
  /** \brief Each grid square counts once for the height of a floor or a ceiling. */
  double edge_of_height_square = 0.5;
  /** \brief Search for the rooms of an opening: largest distance from the side of the
   * wall, and step. */
  double max_to_room = 0.3;
  double step_to_room = 0.05;
  /** \brief The highest sill of a door. */
  double max_threshold = 0.25;
  /** \brief Distance of the rim of a plan from the outermost walls. An end of a wall is
   * free if no other wall passes through it or ends nearer to it than this. */
  double margin_of_plan = 0.5;
  /** \brief A plan with more walls gets no rooms: the number of cells grows with the
   * square of the number of walls. */
  std::size_t max_walls = 1'000;
  /** \brief Grid of points that cover rooms: smallest edge of a square, largest number
   * of squares, and mean points of a square so that few covered squares are empty. */
  double min_edge_of_cover = 0.1;
  double max_cover_squares = 4e6;
  double points_of_cover_square = 3.0;
  /** \brief Largest number of samples of a cell in each direction, for its cover. */
  int max_samples_of_cell = 60;

  // Right angles.
  /** \brief Parallel planes are coplanar within this multiple of their joint rms
   * distance, the root of the sum of both squares. */
  double noises_of_offset = 3.0;
};

inline constexpr BuildingConstants constants;

} // namespace pcl_ops::internal::buildings
