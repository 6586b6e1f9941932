// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "buildings/continuation.h"

#include <cmath>

using namespace pcl_ops::internal::buildings;
using Eigen::Vector3d;

namespace {

/** \brief A rectangle that is level along x; its corner of least x and y is (x, y, z).
 * \param[in] depth extent along y, seen from above [m]
 * \param[in] rise difference of the heights of its ends along y [m] */
PlaneFromAbove
rectangle (double x, double y, double z, double width, double depth, double rise = 0.0)
{
  PlaneFromAbove plane;
  plane.hull = {{x, y, z},
                {x + width, y, z},
                {x + width, y + depth, z + rise},
                {x, y + depth, z + rise}};
  plane.center = 0.5 * (plane.hull[0] + plane.hull[2]);
  plane.normal = Vector3d (0.0, -rise, depth).normalized();
  plane.area = width * std::hypot (depth, rise);
  return plane;
}

/** \brief Whether a level square is a part of the ground, because the ground goes on
 * beside it in one of the other planes. Its height is 5 m, its x and y go from 0 to 10
 * m. */
bool
isSquareContinued (std::vector<PlaneFromAbove> others)
{
  others.insert (others.begin(), rectangle (0, 0, 5, 10, 10));
  return isPartOfGround (others.front(), others);
}

} // namespace

TEST (Continuation, NeedsAPlaneWithin4Meters)
{
  for (const double gap : {0.0, 3.8})
    EXPECT_TRUE (isSquareContinued ({rectangle (10 + gap, 0, 5, 10, 10)})) << gap;
  EXPECT_FALSE (isSquareContinued ({rectangle (14.2, 0, 5, 10, 10)}));
  EXPECT_FALSE (isSquareContinued ({}));
}

TEST (Continuation, NeedsAPlaneWithinAMeterOfTheHeight)
{
  for (const double sign : {-1.0, 1.0}) {
    EXPECT_TRUE (isSquareContinued ({rectangle (10, 0, 5 + 0.95 * sign, 10, 10)}));
    EXPECT_FALSE (isSquareContinued ({rectangle (10, 0, 5 + 1.05 * sign, 10, 10)}));
  }
}

TEST (Continuation, NeedsAPlaneThatIsAtMost20DegreesSteeper)
{
  const auto isContinuedBySlope = [] (double degrees) {
    const double rise = 8.0 * std::tan (degrees * M_PI / 180.0);
    // The rectangle begins at the side y = 10 m of the square, at the same height.
    return isSquareContinued ({rectangle (0, 10, 5, 10, 8, rise)});
  };
  EXPECT_TRUE (isContinuedBySlope (19.0));
  EXPECT_FALSE (isContinuedBySlope (21.0)) << "the other side of a gable";
}

TEST (Continuation, NeedsAPlaneOf2SquareMeters)
{
  EXPECT_TRUE (isSquareContinued ({rectangle (10, 0, 5, 0.21, 10)}));
  EXPECT_FALSE (isSquareContinued ({rectangle (10, 0, 5, 0.19, 10)}));
}

TEST (Continuation, IsNotWhereGroundFarBelowGoesOnUnderneath)
{
  const auto isContinuedOverGround = [] (double depth) {
    return isSquareContinued (
        {rectangle (10, 0, 5, 10, 10), rectangle (-20, -20, 5 - depth, 60, 60)});
  };
  EXPECT_FALSE (isContinuedOverGround (2.0));
  EXPECT_TRUE (isContinuedOverGround (1.8));
}

TEST (Continuation, IsNotWhereMoreThanTwiceAsMuchOfTheOutlineIsAtAStep)
{
  // A plane of the same height lies along a part of the outline, and a step along
  // another part: as long as the first one, or more than twice as long.
  const PlaneFromAbove narrow_flush = rectangle (14, 5, 5, 10, 0.5);
  const PlaneFromAbove step = rectangle (-14, -2, 0, 10.1, 14);
  EXPECT_TRUE (isSquareContinued ({rectangle (10.1, 0, 5, 10, 10), step}));
  EXPECT_FALSE (isSquareContinued ({narrow_flush, step}));
}

TEST (Continuation, IsOnATerraceOfASlope)
{
  const PlaneFromAbove uphill = rectangle (-5, 10, 8, 20, 20, 12);
  const PlaneFromAbove downhill = rectangle (-5, -20, -10, 20, 20, 12);
  EXPECT_TRUE (isSquareContinued ({uphill, downhill}));
}

TEST (Continuation, IsNotOnARoofBesideAHigherOne)
{
  const PlaneFromAbove ground = rectangle (-20, -20, 0, 60, 60);
  EXPECT_FALSE (isSquareContinued ({rectangle (10, 0, 8, 10, 10), ground}));
}

TEST (Continuation, IsNotBesideTheRidgeOfAnotherRoof)
{
  // Two sides of a gable, whose ridge is 6 m higher than the eaves.
  const std::vector<PlaneFromAbove> gable = {rectangle (0, 0, 5, 10, 10, 6),
                                             rectangle (0, 10, 11, 10, 10, -6)};
  EXPECT_FALSE (isPartOfGround (gable.front(), gable));
}

TEST (Continuation, IsNotWhereAPlaneIsHigherByLessThanHeadroom)
{
  EXPECT_TRUE (isSquareContinued ({rectangle (10, 0, 7, 10, 10)}));
  EXPECT_FALSE (isSquareContinued ({rectangle (10, 0, 6.8, 10, 10)}));
}

TEST (Continuation, IsTheSameInEitherOrderOfCorners)
{
  for (const bool is_reversed : {false, true}) {
    PlaneFromAbove ground = rectangle (-20, -20, 0, 60, 60);
    if (is_reversed)
      std::reverse (ground.hull.begin(), ground.hull.end());
    EXPECT_FALSE (isSquareContinued ({rectangle (10, 0, 5, 10, 10), ground}));
  }
}

TEST (Continuation, CountsAllSidesAlike)
{
  // A plane at the height of the square on each of its sides. Some are lowered to the
  // ground: three of four or two of four.
  const std::vector<PlaneFromAbove> flush{rectangle (0, -10, 5, 10, 9),
                                          rectangle (11, 0, 5, 9, 10),
                                          rectangle (0, 11, 5, 10, 9),
                                          rectangle (-10, 0, 5, 9, 10)};
  for (std::size_t side = 0; side < 4; ++side) {
    std::vector<PlaneFromAbove> one_flush = flush;
    std::vector<PlaneFromAbove> two_flush = flush;
    for (std::size_t i = 1; i < 4; ++i) {
      PlaneFromAbove& ground = one_flush[(side + i) % 4];
      ground.center.z() = 0.0;
      for (Vector3d& corner : ground.hull)
        corner.z() = 0.0;
      if (i > 1)
        two_flush[(side + i) % 4] = ground;
    }
    EXPECT_FALSE (isSquareContinued (one_flush)) << side;
    EXPECT_TRUE (isSquareContinued (two_flush)) << side;
  }
}

TEST (Lowest, IsWhatHasNoPlaneBelowMostOfIt)
{
  // A square of 10 m with another plane below a part of it, this wide and this far
  // below.
  const auto isSquareLowest = [] (double width, double drop) {
    constexpr double min_drop = 1.9;
    const std::vector<PlaneFromAbove> planes{rectangle (0, 0, 5, 10, 10),
                                             rectangle (0, 0, 5 - drop, width, 10)};
    return isLowest (planes.front(), planes, min_drop);
  };
  EXPECT_TRUE (isSquareLowest (4.0, 5.0));
  EXPECT_FALSE (isSquareLowest (6.0, 5.0));
  EXPECT_TRUE (isSquareLowest (6.0, 1.8)) << "less far below than counts";
}
