// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "board_furniture.h"

#include "poses.h"

namespace pcl_ops::simulation {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/** \brief From the rim of a board to the posts below it [m]. */
constexpr double overhang = 0.03;
/** \brief Between parallel faces that would else be in one plane [m]: more than the
 * noise of a depth camera hides. */
constexpr double offset_of_faces = 0.02;

double
drawThickness (internal::RandomGenerator& generator)
{
  return drawBetween (generator, thinnest_board, thickest_board);
}

Furniture
emptyPiece (const Vector2d& footprint)
{
  Furniture piece{{}, footprint};
  piece.body.narrowest_surface = 0.0;
  return piece;
}

/** \brief \param[in] top height of its upper side [m] */
void
addBoard (Body& body, const Vector2d& size, double top, double thickness)
{
  addBox (body, at (0.0, 0.0, top - 0.5 * thickness), {size.x(), size.y(), thickness});
}

/** \brief Posts below the four corners of a board of that size. Those on one side stand
 * farther in than those on the other, so that their faces are in different planes. */
void
addPosts (Body& body, const Vector2d& size, double height, double width)
{
  const double step = width + offset_of_faces;
  for (const double side_x : {-1.0, 1.0})
    for (const double side_y : {-1.0, 1.0}) {
      const double inset = overhang + 0.5 * width;
      const double x = 0.5 * size.x() - inset - (side_y > 0.0 ? step : 0.0);
      const double y = 0.5 * size.y() - inset - (side_x > 0.0 ? step : 0.0);
      addBox (body,
              at (side_x * x, side_y * y, 0.5 * height),
              {width, width, height},
              HiddenFace::BottomAndTop);
    }
}

Furniture
makeBoardOnPosts (const Vector3d& size, internal::RandomGenerator& generator)
{
  Furniture piece = emptyPiece (size.head<2>());
  const double thickness = drawThickness (generator);
  addBoard (piece.body, size.head<2>(), size.z(), thickness);
  addPosts (
      piece.body, size.head<2>(), size.z() - thickness, drawThickness (generator));
  return piece;
}

} // namespace

Furniture
makeBoardTable (internal::RandomGenerator& generator)
{
  const Vector3d size = drawInBox (generator, {0.7, 0.5, 0.6}, {1.4, 0.8, 0.8});
  return makeBoardOnPosts (size, generator);
}

Furniture
makeBoardBench (internal::RandomGenerator& generator)
{
  const Vector3d size = drawInBox (generator, {0.8, 0.38, 0.4}, {1.4, 0.45, 0.5});
  return makeBoardOnPosts (size, generator);
}

Furniture
makeBoardRack (internal::RandomGenerator& generator)
{
  const int boards = 3 + int (internal::drawBelow (generator, 2));
  const double pitch = drawBetween (generator, 0.3, 0.45);
  const double thickness = drawThickness (generator);
  Vector2d size = drawInBox (generator, {0.7, 0.5, 0.0}, {1.1, 0.6, 0.0}).head<2>();
  Furniture rack = emptyPiece (size);
  for (int i = 1; i <= boards; ++i) {
    addBoard (rack.body, size, i * pitch, thickness);
    if (i < boards)
      size -= Vector2d::Constant (2.0 * offset_of_faces);
  }
  addPosts (rack.body, size, boards * pitch - thickness, drawThickness (generator));
  return rack;
}

} // namespace pcl_ops::simulation
