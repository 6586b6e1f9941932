// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "plane_board.h"
#include "planes/patch.h"

using namespace pcl_ops;
using namespace pcl_ops::internal;
using Eigen::Vector3d;

TEST (Patch, OfARectangleIsTheRectangle)
{
  const Patch patch =
      patchOf (board ({5, 0, 1}, Vector3d::UnitZ(), {3.0, 2.0})).value();
  EXPECT_TRUE (patch.half_sides.isApprox (Eigen::Vector2d (1.5, 1.0), 0.01));
  EXPECT_NEAR (std::abs (patch.axes (0, 0)), 1.0, 1e-6) << "its long side is along x";
  EXPECT_NEAR (patch.area(), 6.0, 0.1);
}

TEST (Patch, OfPointsOnALineIsNone)
{
  PlaneSegment line;
  for (int i = 0; i < 10; ++i)
    line.moments.add (i, 0, 0);
  EXPECT_FALSE (patchOf (line));
}

TEST (CommonArea, IsThatOfTheOverlapOfTwoSquares)
{
  // A level square of 2 m x 2 m around (x, 0, 0), turned about z by an angle [rad].
  const auto square = [] (double x, double angle) {
    Patch patch;
    patch.half_sides = {1.0, 1.0};
    return moved (Eigen::Translation3d (x, 0, 0) *
                      Eigen::AngleAxisd (angle, Vector3d::UnitZ()),
                  patch);
  };
  EXPECT_NEAR (commonArea (square (0, 0), square (0, 0)), 4.0, 1e-12);
  EXPECT_NEAR (commonArea (square (0, 0), square (1.5, 0)), 1.0, 1e-12);
  EXPECT_NEAR (commonArea (square (0, 0), square (2.5, 0)), 0.0, 1e-12);
  // An octagon between the square and itself turned by 45 degrees.
  EXPECT_NEAR (commonArea (square (0, 0), square (0, 45_deg)),
               8.0 * (std::sqrt (2.0) - 1.0),
               1e-9);
}
