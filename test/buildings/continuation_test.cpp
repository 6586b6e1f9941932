// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "buildings/continuation.h"

#include <algorithm>
#include <cmath>

using namespace pcl_ops::internal::buildings;
using Eigen::Vector3d;

namespace {

/** \brief A rectangle that is level along x; its corner of least x and y is (x, y, z).
 * \param[in] width,depth extents along x and y, seen from above [m]
 * \param[in] rise how much higher the end of largest y is than that of least y [m] */
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

/** \brief Whether a level square at a height of 5 m, with x and y from 0 to 10 m, is a
 * part of the ground: one of the other planes continues it. */
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
    constexpr double depth = 8.0;
    const double rise = depth * std::tan (degrees * M_PI / 180.0);
    // The rectangle begins at the side y = 10 m of the square, at the same height.
    return isSquareContinued ({rectangle (0, 10, 5, 10, depth, rise)});
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
  // A plane of the same height beside the square, and ground below both of them.
  const auto isContinuedOverGround = [] (double drop) {
    return isSquareContinued (
        {rectangle (10, 0, 5, 10, 10), rectangle (-20, -20, 5 - drop, 60, 60)});
  };
  EXPECT_FALSE (isContinuedOverGround (2.0));
  EXPECT_TRUE (isContinuedOverGround (1.8));
}

TEST (Continuation, IsNotWhereMoreThanTwiceAsMuchOfTheOutlineIsAtAStep)
{
  // A plane of the same height lies beside one side of the square, and another plane, 5
  // m lower, beside the opposite side.
  const PlaneFromAbove step = rectangle (-14, -2, 0, 10.1, 14);
  const PlaneFromAbove as_long_as_the_step = rectangle (10.1, 0, 5, 10, 10);
  const PlaneFromAbove far_shorter_than_the_step = rectangle (14, 5, 5, 10, 0.5);
  EXPECT_TRUE (isSquareContinued ({as_long_as_the_step, step}));
  EXPECT_FALSE (isSquareContinued ({far_shorter_than_the_step, step}));
}

TEST (Continuation, IsOnATerraceOfASlope)
{
  // Both parts of the slope rise along y by 12 m on 20 m. The one uphill begins 3 m
  // above the square, the one downhill ends 3 m below.
  const PlaneFromAbove uphill = rectangle (-5, 10, 8, 20, 20, 12);
  const PlaneFromAbove downhill = rectangle (-5, -20, -10, 20, 20, 12);
  EXPECT_TRUE (isSquareContinued ({uphill, downhill}));
}

TEST (Continuation, IsNotOnARoofBesideAHigherOne)
{
  const PlaneFromAbove higher_roof = rectangle (10, 0, 8, 10, 10);
  const PlaneFromAbove ground = rectangle (-20, -20, 0, 60, 60);
  EXPECT_FALSE (isSquareContinued ({higher_roof, ground}));
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
  // The headroom is 1.9 m.
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

TEST (Continuation, IsTheSameWhicheverCornerComesFirst)
{
  // A roof of 10 m x 7 m beside a drop, and near one end a plane that continues it.
  std::vector<PlaneFromAbove> planes = {rectangle (0, 0, 5, 10, 7),
                                        rectangle (-20, -10, 0, 20, 30),
                                        rectangle (12, 4, 5, 10, 10)};
  std::vector<Vector3d>& hull = planes.front().hull;
  const bool is_ground = isPartOfGround (planes.front(), planes);
  for (std::size_t corner = 1; corner < hull.size(); ++corner) {
    std::rotate (hull.begin(), hull.begin() + 1, hull.end());
    EXPECT_EQ (isPartOfGround (planes.front(), planes), is_ground) << corner;
  }
}

TEST (Continuation, CountsAllSidesAlike)
{
  // Beside each side of the square a plane, at the height of the square or at 0. If
  // only one is at the height of the square, it is not continued; if two are, it is.
  const std::vector<PlaneFromAbove> all_flush{rectangle (0, -10, 5, 10, 9),
                                              rectangle (11, 0, 5, 9, 10),
                                              rectangle (0, 11, 5, 10, 9),
                                              rectangle (-10, 0, 5, 9, 10)};
  for (std::size_t side = 0; side < 4; ++side) {
    std::vector<PlaneFromAbove> one_flush = all_flush;
    std::vector<PlaneFromAbove> two_flush = all_flush;
    for (std::size_t i = 1; i < 4; ++i) {
      PlaneFromAbove& lowered = one_flush[(side + i) % 4];
      lowered.center.z() = 0.0;
      for (Vector3d& corner : lowered.hull)
        corner.z() = 0.0;
      if (i > 1)
        two_flush[(side + i) % 4] = lowered;
    }
    EXPECT_FALSE (isSquareContinued (one_flush)) << side;
    EXPECT_TRUE (isSquareContinued (two_flush)) << side;
  }
}

TEST (IsLowest, IsTrueOfAPlaneWithoutAnotherFarBelowMostOfIt)
{
  // A square of 10 m x 10 m, and below it, by a drop, another plane of this width and
  // of the same depth.
  const auto isSquareLowest = [] (double width, double drop) {
    constexpr double min_drop = 1.9;
    const std::vector<PlaneFromAbove> planes{rectangle (0, 0, 5, 10, 10),
                                             rectangle (0, 0, 5 - drop, width, 10)};
    return isLowest (planes.front(), planes, min_drop);
  };
  EXPECT_TRUE (isSquareLowest (4.0, 5.0));
  EXPECT_FALSE (isSquareLowest (6.0, 5.0));
  EXPECT_TRUE (isSquareLowest (6.0, 1.8)) << "the drop is less than min_drop";
}
