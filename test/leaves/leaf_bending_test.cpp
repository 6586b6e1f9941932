// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "leaf_scene.h"
#include "leaves/leaf_bending.h"

using namespace pcl_ops::internal;

namespace {

/** \brief The bending of a surface above a square about zero.
 * \param[in] number of leaves that are looked at, from the first one on */
template <typename Height>
LeafBending
bendingOver (double half_edge,
             double noise,
             Height&& heightAt,
             std::size_t number = 1000000)
{
  LeafScene scene (pointsOver (half_edge, noise, heightAt));
  const Indices leaves = upTo (std::min (number, scene.cloud.size()));
  pcl_ops::Moments moments;
  for (const std::uint32_t leaf : leaves)
    moments.addAligned (scene.cloud.moments[leaf]);
  return bendingOfLeaves (scene.cloud, leaves, pcl_ops::fitPlane (moments)->plane);
}

double
slopeOver (double x, double y)
{
  return 0.05 + 0.3 * x - 0.2 * y;
}

double
barrelOver (double x, double)
{
  return std::sqrt (1.0 - x * x);
}

} // namespace

TEST (LeafBending, ExplainsNothingOfANoisyPlane)
{
  const LeafBending bending = bendingOver (50_cm, 1_cm, slopeOver);
  EXPECT_LT (bending.explained, 0.2);
  EXPECT_LT (bending.amplitude, 2_mm);
  EXPECT_NEAR (bending.left, 5.5e-3, 1_mm) << "all of the noise is left";
  EXPECT_FALSE (isCurved (bending));
}

TEST (LeafBending, OfALargePlaneIsToldByFiveHundredLeaves)
{
  // 6,400 leaves; 0.1 x^2 for x up to 4 m: 1.6 m at either end.
  const LeafBending bending =
      bendingOver (4_m, 1_cm, [] (double x, double) { return 0.1 * x * x; });
  EXPECT_GE (bending.leaves, 400u);
  EXPECT_LE (bending.leaves, 500u);
  EXPECT_NEAR (bending.amplitude, 1.6, 5_cm);
  EXPECT_NEAR (bending.half_extent, 4_m, 20_cm);
  EXPECT_GT (bending.explained, 0.9);
  EXPECT_LT (bending.left, 4_cm);
}

TEST (LeafBending, IsThatOfAParaboloid)
{
  // 0.1 x^2 for x up to 50 cm: 25 mm at either end, in the direction of x.
  const LeafBending bending =
      bendingOver (50_cm, 0.0, [] (double x, double) { return 0.1 * x * x; });
  EXPECT_NEAR (bending.amplitude, 25_mm, 1.5e-3);
  EXPECT_NEAR (bending.half_extent, 50_cm, 3_cm);
  EXPECT_GT (bending.explained, 0.9);
  EXPECT_LT (bending.left, 2_mm);
}

TEST (LeafBending, OfCylindersBallsAndSaddlesIsACurve)
{
  EXPECT_TRUE (isCurved (bendingOver (50_cm, 5_mm, barrelOver)));
  EXPECT_TRUE (isCurved (bendingOver (50_cm, 5_mm, [] (double x, double y) {
    return std::sqrt (1.0 - x * x - y * y);
  })));
  EXPECT_TRUE (isCurved (
      bendingOver (50_cm, 5_mm, [] (double x, double y) { return 0.5 * x * y; })));
}

TEST (LeafBending, OfAWallBentByACentimeterIsNoCurve)
{
  // Up to 1 cm in the middle of 4 m.
  const LeafBending bending = bendingOver (
      2_m, 0.0, [] (double x, double) { return 0.05 + 1_cm * (1.0 - x * x / 4.0); });
  EXPECT_GT (bending.explained, 0.9) << "it is bent all the same";
  EXPECT_FALSE (isCurved (bending));
}

TEST (LeafBending, ThatExplainsLittleOfTheUnevennessIsNoCurve)
{
  LeafBending bending = bendingOver (50_cm, 0.0, barrelOver);
  ASSERT_TRUE (isCurved (bending));
  bending.explained = 0.1;
  EXPECT_FALSE (isCurved (bending));
}

TEST (LeafBending, OfAFewLeavesIsNone)
{
  EXPECT_EQ (bendingOver (50_cm, 0.0, barrelOver, 6).amplitude, 0.0);
  EXPECT_FALSE (isCurved (bendingOver (50_cm, 0.0, barrelOver, 6)));
  EXPECT_GT (bendingOver (50_cm, 0.0, barrelOver, 20).amplitude, 0.0);
}
