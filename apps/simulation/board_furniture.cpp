// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "furniture.h"

namespace pcl_ops::simulation {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/** \brief Between parallel faces that would else be in one plane [m]: more than the
 * noise of a depth camera hides. */
constexpr double offset_of_faces = 0.02;

/** \brief Of boards, and of posts [m]. */
double
drawThickness (Random& random)
{
  return random.between (0.02, 0.06);
}

/** \brief Posts below the four corners of a board of that size. Those on one side stand
 * farther in than those on the other, so that their faces are in different planes. */
void
addPosts (Body& body, const Vector2d& size, double height, double width)
{
  constexpr double overhang = 0.03; // from the rim of the board to the posts [m]
  const double step = width + offset_of_faces, inset = overhang + 0.5 * width;
  for (const double side_x : {-1.0, 1.0})
    for (const double side_y : {-1.0, 1.0}) {
      const double x = 0.5 * size.x() - inset - (side_y > 0.0 ? step : 0.0);
      const double y = 0.5 * size.y() - inset - (side_x > 0.0 ? step : 0.0);
      addBox (body,
              at (side_x * x, side_y * y, 0.5 * height),
              {width, width, height},
              HiddenFace::BottomAndTop);
    }
}

/** \param[in] size of the lowest board, each of the others is a little smaller [m]
 * \param[in] pitch from board to board [m] */
Furniture
boardsOnPosts (
    int boards, double pitch, Vector2d size, double thickness, Random& random)
{
  Furniture piece{{}, size};
  piece.body.narrowest_surface = 0.0;
  for (int i = 1; i <= boards; ++i) {
    addBox (piece.body,
            at (0.0, 0.0, i * pitch - 0.5 * thickness),
            {size.x(), size.y(), thickness});
    if (i < boards)
      size -= Vector2d::Constant (2.0 * offset_of_faces);
  }
  addPosts (piece.body, size, boards * pitch - thickness, drawThickness (random));
  return piece;
}

Furniture
drawBoardOfSize (const Vector3d& smallest, const Vector3d& largest, Random& random)
{
  const Vector3d size = random.inBox (smallest, largest);
  const double thickness = drawThickness (random);
  return boardsOnPosts (1, size.z(), size.head<2>(), thickness, random);
}

} // namespace

Furniture
drawBoardTable (Random& random)
{
  return drawBoardOfSize ({0.7, 0.5, 0.6}, {1.4, 0.8, 0.8}, random);
}

Furniture
drawBoardBench (Random& random)
{
  return drawBoardOfSize ({0.8, 0.38, 0.4}, {1.4, 0.45, 0.5}, random);
}

Furniture
drawBoardRack (Random& random)
{
  const int boards = 3 + int (random.below (2));
  const double pitch = random.between (0.3, 0.45), thickness = drawThickness (random);
  const Vector3d size = random.inBox ({0.7, 0.5, 0.0}, {1.1, 0.6, 0.0});
  return boardsOnPosts (boards, pitch, size.head<2>(), thickness, random);
}

} // namespace pcl_ops::simulation
