// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "furniture.h"

#include <iterator>

namespace pcl_ops::simulation {

namespace {

// Lengths and heights are in meters; they are those of common furniture. Sizes are
// along x (width), y (depth) and z (height).

/** Adds a box without its lower face.
 * \param[in] foot middle of the lower face */
void
addStandingBox (Body& body, const Vector3d& foot, const Vector3d& size)
{
  const Vector3d center (foot.x(), foot.y(), foot.z() + 0.5 * size.z());
  body.addBox (at (center), size, HiddenFace::Bottom);
}

/** Dimensions of \ref plateOnLegs. */
struct Plate {
  double thickness;  // of the plate
  double leg_radius; // of each leg
};

/** Makes a plate on four round legs.
 * \param[in] size of the whole, with the legs */
Body
plateOnLegs (const Vector3d& size, const Plate& plate)
{
  const auto [thickness, leg_radius] = plate;
  Body body{size.head<2>()};
  const double height = size.z() - thickness;
  const double inset = 3.0 * leg_radius;
  body.addBox (at ({0, 0, size.z() - 0.5 * thickness}),
               {size.x(), size.y(), thickness});
  for (const double x : {-0.5, 0.5})
    for (const double y : {-0.5, 0.5})
      body.addPole (
          {x * (size.x() - inset), y * (size.y() - inset), 0}, height, leg_radius);
  return body;
}

/** Adds a row of books along x until it is at least \p width wide.
 * \param[in] start where the row begins, at the foot of the books, in the middle of
 * their depth */
void
addBooks (Body& body, const Vector3d& start, double width, Random& random)
{
  for (double end = 0.0; end < width;) {
    const Vector3d size = random.inBox ({0.02, 0.14, 0.18}, {0.045, 0.2, 0.26});
    end += size.x();
    const double middle = start.x() + end - 0.5 * size.x();
    addStandingBox (body, {middle, start.y(), start.z()}, size);
  }
}

/** \param[in] foot middle of the lower end of the mug */
void
addMug (Body& body, const Vector3d& foot)
{
  constexpr double height = 0.1;
  constexpr double radius = 0.04;
  body.addPole (foot, height, radius);
}

/** Draws a table with a mug and a ball on it. */
Body
drawTable (Random& random)
{
  const Vector3d size = random.inBox ({0.8, 0.6, 0.42}, {1.8, 0.95, 0.78});
  Body table = plateOnLegs (size, Plate{0.035, 0.03});
  const Vector3d mug (random.between (-0.3, 0.3), 0.1, size.z());
  addMug (table, mug);
  constexpr double ball_radius = 0.08;
  table.addSphere (mug + Vector3d (0.2, -0.2, ball_radius), ball_radius);
  return table;
}

/** Adds a tilted monitor on a stand.
 * \param[in] foot middle of the lower end of the stand */
void
addMonitor (Body& desk, const Vector3d& foot, Random& random)
{
  constexpr double stand_height = 0.2;
  constexpr double behind_screen = 0.05; // from the stand to the screen
  constexpr double below_screen = 0.1;   // from the desk to the screen
  constexpr double stand_radius = 0.03;
  constexpr double base_height = 0.015; // of the disk under the stand
  constexpr double base_radius = 0.12;
  const Vector3d size (random.between (0.45, 0.7), 0.04, 0.36); // of the screen
  desk.addPole (foot, stand_height, stand_radius);
  desk.addPole (foot, base_height, base_radius);
  const double tilt = random.angle (0, 12);
  const double yaw = random.angle (-25, 25);
  desk.addBox (at ({foot.x(),
                    foot.y() + behind_screen,
                    foot.z() + below_screen + 0.5 * size.z()}) *
                   turnZ (yaw) * turnX (tilt),
               size);
}

/** Adds an open laptop.
 * \param[in] position middle of its hinge, on the desk */
void
addLaptop (Body& desk, const Vector3d& position, Random& random)
{
  const Vector3d keyboard (0.34, 0.24, 0.018);
  const Vector3d lid (0.34, 0.008, 0.24);
  const Isometry3d hinge = at (position) * turnZ (random.angle (-30, 30));
  const Isometry3d opened = hinge * turnX (random.angle (5, 35));
  desk.addBox (hinge * at ({0, 0.5 * keyboard.y(), 0.5 * keyboard.z()}),
               keyboard,
               HiddenFace::Bottom);
  desk.addBox (opened * at ({0, 0, 0.5 * lid.z()}), lid);
}

/** Draws a desk with drawers, a monitor, an open laptop, books and a mug. */
Body
drawDesk (Random& random)
{
  const Vector3d size = random.inBox ({1.2, 0.65, 0.7}, {1.8, 0.85, 0.76});
  const double x = size.x();
  const double top = size.z();
  constexpr double drawers = 0.42; // width of the box of drawers
  Body desk = plateOnLegs (size, Plate{0.03, 0.03});
  // The box of drawers is narrower than the plate and does not touch it.
  addStandingBox (
      desk, {0.5 * (x - drawers) - 0.03, 0, 0}, {drawers, size.y() - 0.1, top - 0.1});
  addMonitor (desk, {-0.2 * x, -0.15, top}, random);
  addLaptop (desk, {0.25 * x, -0.05, top}, random);
  addBooks (desk, {0.02 * x, -0.2, top}, 0.12, random);
  addMug (desk, {-0.4 * x, 0.15, top});
  return desk;
}

Body
drawCupboard (Random& random)
{
  const Vector3d size = random.inBox ({0.5, 0.35, 0.7}, {1.4, 0.6, 2.1});
  Body cupboard{size.head<2>()};
  addStandingBox (cupboard, {0, 0, 0}, size);
  return cupboard;
}

Body
drawShelf (Random& random)
{
  constexpr double thickness = 0.025;
  constexpr double depth = 0.3;
  const int boards = 3 + int (random.below (3));
  const double pitch = random.between (0.33, 0.4); // height from board to board
  const double width = random.between (0.7, 1.2);
  const double height = boards * pitch;
  Body shelf{{width, depth}};
  for (const double side : {-0.5, 0.5})
    addStandingBox (shelf, {side * width, 0, 0}, {thickness, depth, height});
  addStandingBox (shelf, {0, -0.5 * depth, 0}, {width, thickness, height});
  for (int i = 0; i <= boards; ++i)
    shelf.addBox (at ({0, 0, i * pitch}), {width, depth, thickness});
  for (int i = 1; i < boards; ++i)
    if (random.chance (0.6))
      addBooks (shelf,
                {-0.45 * width, -0.03, i * pitch + 0.5 * thickness},
                random.between (0.1, 0.6),
                random);
  return shelf;
}

Body
drawBed (Random& random)
{
  const Vector3d size = random.inBox ({0.9, 2.0, 0.4}, {1.6, 2.0, 0.6});
  const double x = size.x();
  const double y = size.y();
  const double z = size.z();
  constexpr double headboard = 0.06;        // thickness
  constexpr double above_mattress = 0.4;    // height of the headboard over the mattress
  constexpr double radius_of_pillow = 0.12; // a roll, partly sunk into the mattress
  Body bed{{x, y}};
  addStandingBox (bed, {0, 0.5 * headboard, 0}, {x, y - headboard, z});
  addStandingBox (
      bed, {0, 0.5 * (headboard - y), 0}, {x, headboard, z + above_mattress});
  const Vector3d pillow (0.0, -0.5 * y + 0.3, z + 0.02);
  bed.addCylinder (pillow, Vector3d::UnitX(), 0.4 * x, radius_of_pillow);
  return bed;
}

Body
drawSofa (Random& random)
{
  constexpr double depth = 0.85;
  constexpr double arm = 0.18; // width of an armrest
  const double width = random.between (1.4, 2.2);
  const double seat = random.between (0.38, 0.46); // height
  Body sofa{{width, depth}};
  addStandingBox (sofa, {0, 0, 0}, {width - 2.0 * arm, depth, seat});
  for (const double side : {-0.5, 0.5})
    addStandingBox (sofa, {side * (width - arm), 0, 0}, {arm, depth, seat + 0.2});
  // The back leans backwards.
  sofa.addBox (at ({0, -0.5 * depth + 0.22, seat + 0.2}) * turnX (random.angle (8, 20)),
               {width - 2.0 * arm, 0.15, 0.5});
  return sofa;
}

Body
drawChair (Random& random)
{
  const Vector3d size = random.inBox ({0.4, 0.4, 0.42}, {0.5, 0.5, 0.48});
  Body chair = plateOnLegs (size, Plate{0.04, 0.018});
  const Vector3d back (0, -0.5 * size.y(), size.z() + 0.22);
  chair.addBox (at (back) * turnX (random.angle (3, 15)), {size.x(), 0.03, 0.42});
  return chair;
}

/** Draws one box, or two boxes on top of each other, the upper one turned. */
Body
drawCartons (Random& random)
{
  const Vector3d lower = random.inBox ({0.35, 0.35, 0.25}, {0.7, 0.6, 0.5});
  Body cartons{lower.head<2>()};
  addStandingBox (cartons, {0, 0, 0}, lower);
  if (random.chance (0.5)) {
    const Vector3d upper = random.between (0.5, 0.8) * lower;
    const Isometry3d on_top = at ({0, 0, lower.z() + 0.5 * upper.z()});
    cartons.addBox (on_top * turnZ (random.angle (-40, 40)), upper, HiddenFace::Bottom);
  }
  return cartons;
}

/** Draws a tilted panel on a round post. */
Body
drawTiltedPanel (Random& random)
{
  const Vector3d size = random.inBox ({0.7, 0.5, 0.025}, {1.3, 0.95, 0.025});
  const double height = random.between (0.8, 1.3); // of the panel's center
  Body panel{Vector2d::Constant (size.head<2>().norm())};
  const double yaw = random.angle (-25, 25);
  const double tilt = random.angle (25, 75);
  panel.addBox (at ({0, 0, height}) * turnX (tilt) * turnZ (yaw), size);
  constexpr double post_radius = 0.03;
  constexpr double base_height = 0.03; // of the disk under the post
  constexpr double base_radius = 0.25;
  panel.addPole ({0, 0, 0}, height - 0.06, post_radius);
  panel.addPole ({0, 0, 0}, base_height, base_radius);
  return panel;
}

/** Range of the thickness of boards and of the width of posts. */
constexpr double thinnest = 0.02, thickest = 0.06;

/** Makes boards above each other on four posts. No two faces are coplanar: posts on one
 * side stand farther in than posts on the other side, and each board is smaller than
 * the board below.
 * \param[in] boards number of boards
 * \param[in] pitch height from board to board
 * \param[in] size of the lowest board along x and y
 * \param[in] thickness of each board */
Body
boardsOnPosts (
    int boards, double pitch, const Vector2d& size, double thickness, Random& random)
{
  // Offset between parallel faces, visible through the noise of a depth camera.
  constexpr double offset_of_faces = 0.02;
  constexpr double overhang = 0.03; // from the edge of the highest board to the posts
  Body piece{size};
  piece.narrowest_surface = 0.0;
  Vector2d board = size; // size of a board; after the loop of the highest one
  for (int i = 1; i <= boards; ++i) {
    piece.addBox (at ({0, 0, i * pitch - 0.5 * thickness}),
                  {board.x(), board.y(), thickness});
    if (i < boards)
      board -= Vector2d::Constant (2.0 * offset_of_faces);
  }
  const double height = boards * pitch - thickness;
  const double width = random.between (thinnest, thickest); // of the posts
  const double step = width + offset_of_faces; // how much farther in posts stand
  const double inset = overhang + 0.5 * width; // of the middle of other posts
  for (const double side_x : {-1.0, 1.0})
    for (const double side_y : {-1.0, 1.0}) {
      // Posts at +y stand farther in along x, those at +x farther in along y.
      const double x = 0.5 * board.x() - inset - (side_y > 0.0 ? step : 0.0);
      const double y = 0.5 * board.y() - inset - (side_x > 0.0 ? step : 0.0);
      piece.addBox (at ({side_x * x, side_y * y, 0.5 * height}),
                    {width, width, height},
                    HiddenFace::BottomAndTop);
    }
  return piece;
}

/** Draws one board on posts, of a size in a range along each axis. */
Body
drawBoardBetween (const Vector3d& smallest, const Vector3d& largest, Random& random)
{
  const Vector3d size = random.inBox (smallest, largest);
  return boardsOnPosts (
      1, size.z(), size.head<2>(), random.between (thinnest, thickest), random);
}

} // namespace

Body
drawLeaningBoard (Random& random)
{
  const Vector3d size = random.inBox ({0.5, 0.03, 0.8}, {1.3, 0.03, 1.9});
  const double lean = random.angle (10, 35);
  const double roll = random.angle (-8, 8);
  const double depth = size.z() * std::sin (lean) + 0.1;
  // Height of the middle of the lower edge, so that its lower end is on the floor.
  const double lift = 0.5 * size.x() * std::abs (std::sin (roll));
  Body board{{size.x() + 0.2, depth}};
  board.addBox (at ({0, 0.5 * depth, lift}) * turnX (lean) * turnY (roll) *
                    at ({0, 0, 0.5 * size.z()}),
                size);
  return board;
}

Body
drawRamp (Random& random)
{
  const Vector3d size = random.inBox ({0.7, 1.0, 0.03}, {1.2, 1.9, 0.03});
  const double slope = random.angle (15, 40);
  const double run = size.y() * std::cos (slope);
  const double rise = size.y() * std::sin (slope);
  Body ramp{{size.x(), run}};
  ramp.addBox (at ({0, 0, 0.5 * rise + 0.02}) * turnX (slope), size);
  constexpr double post_radius = 0.025;
  for (const double side : {-0.4, 0.4}) // the posts are below the upper end
    ramp.addPole ({side * size.x(), 0.45 * run, 0}, 0.9 * rise, post_radius);
  return ramp;
}

Body
drawRoundClutter (Random& random)
{
  enum { Ball, Bin, Lamp, Carpet, kinds };
  // Smallest and largest radius of each kind; that of a lamp is of its round shade.
  constexpr double radii[][2] = {{0.1, 0.35}, {0.1, 0.2}, {0.12, 0.22}, {0.08, 0.15}};
  const std::uint32_t kind = random.below (kinds);
  const double height_of_lamp = kind == Lamp ? random.between (1.2, 1.7) : 0.0;
  const double radius = random.between (radii[kind][0], radii[kind][1]);
  Body clutter{Vector2d::Constant (2.0 * radius)};
  if (kind == Ball)
    clutter.addSphere ({0, 0, radius}, radius);
  else if (kind == Bin)
    clutter.addPole ({0, 0, 0}, random.between (0.3, 0.6), radius);
  else if (kind == Lamp) {
    constexpr double post_radius = 0.02;
    constexpr double base_height = 0.03; // of the disk under the post
    constexpr double base_radius = 0.15;
    clutter.addPole ({0, 0, 0}, height_of_lamp, post_radius);
    clutter.addPole ({0, 0, 0}, base_height, base_radius);
    clutter.addSphere ({0, 0, height_of_lamp}, radius);
  }
  else {
    const double length = clutter.footprint.x() = random.between (0.8, 1.6);
    clutter.addCylinder ({0, 0, radius}, Vector3d::UnitX(), 0.5 * length, radius);
  }
  return clutter;
}

Body
drawAtWall (Random& random)
{
  using Draw = Body (*) (Random&);
  constexpr Draw draw[] = {
      drawDesk, drawCupboard, drawShelf, drawBed, drawSofa, drawLeaningBoard};
  return draw[random.below (std::uint32_t (std::size (draw)))](random);
}

Body
drawAnywhere (Random& random)
{
  using Draw = Body (*) (Random&);
  constexpr Draw draw[] = {
      drawTable, drawChair, drawCartons, drawTiltedPanel, drawRoundClutter};
  return draw[random.below (std::uint32_t (std::size (draw)))](random);
}

Body
drawBoardTable (Random& random)
{
  return drawBoardBetween ({0.7, 0.5, 0.6}, {1.4, 0.8, 0.8}, random);
}

Body
drawBoardBench (Random& random)
{
  return drawBoardBetween ({0.8, 0.38, 0.4}, {1.4, 0.45, 0.5}, random);
}

Body
drawBoardRack (Random& random)
{
  const int boards = 3 + int (random.below (2));
  const double pitch = random.between (0.3, 0.45);
  const double thickness = random.between (thinnest, thickest);
  const Vector3d size = random.inBox ({0.7, 0.5, 0.0}, {1.1, 0.6, 0.0});
  return boardsOnPosts (boards, pitch, size.head<2>(), thickness, random);
}

} // namespace pcl_ops::simulation
