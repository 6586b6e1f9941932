// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "leaf_scene.h"
#include "leaves/leaf_joining.h"
#include "leaves/leaf_noise.h"

using namespace pcl_ops::internal;

namespace {

JoiningParameters
usualJoining ()
{
  return {2.0, true, 7_deg, 2.0};
}

/** \brief Fits the planes and measures their noise, then joins them. */
void
join (LeafScene& scene, const JoiningParameters& parameters = usualJoining())
{
  refitPlanes (scene.cloud, scene.planes);
  measureNoise (scene.cloud, 1, scene.planes);
  joinPlanes (scene.cloud, parameters, 1, scene.planes);
}

/** \brief A surface of its own plane from the place on where the ground ends, after
 * joining: how many planes. */
std::size_t
planesOfGroundAnd (const Surface& other,
                   double noise,
                   const JoiningParameters& parameters = usualJoining())
{
  LeafScene scene ({ground, other}, noise);
  scene.addPlane (ground, 0.0, before (2.0));
  scene.addPlane (other, 0.0, behind (2.0));
  join (scene, parameters);
  return scene.planesWithLeaves();
}

Surface
anotherGround (double x, double height)
{
  return {{x, 0, 0.05 + height}, {2, 0, 0}, {0, 2, 0}};
}

} // namespace

TEST (LeafJoining, MakesOnePlaneOfPiecesThatNoiseDivided)
{
  LeafScene scene ({ground}, 2_cm, 1_cm);
  scene.addPlane (ground, 0.0, before (0.7));
  scene.addPlane (
      ground, 0.0, [] (const auto& at) { return at.x() > 0.7 && at.x() < 1.3; });
  scene.addPlane (ground, 0.0, [] (const auto& at) { return at.x() > 1.3; });
  join (scene);
  EXPECT_EQ (scene.planesWithLeaves(), 1u);
  EXPECT_EQ (scene.leavesOn (scene.planes.plane_of_leaf[0]), scene.cloud.size());
}

TEST (LeafJoining, FitsThePlaneAnew)
{
  // Of the smaller half, which goes into the larger one, the plane was tilted, too.
  LeafScene scene ({ground}, 2_cm, 1_cm);
  scene.addPlane (ground, 0.0, before (0.5));
  scene.addPlane (ground, 0.0, behind (0.5));
  join (scene);
  EXPECT_EQ (momentsOfPlanes (scene.cloud, scene.planes)[1].count, 14400.0);
  EXPECT_TRUE (isNear (scene.planes.planes[1], ground, 0.1_deg, 1_mm));
}

TEST (LeafJoining, MakesOnePlaneOfABentSurfaceInPieces)
{
  // Bent by 1 cm at its ends. Its pieces have a noise of less than 1 mm and lie several
  // off each other's planes, but meet within 2.
  LeafScene scene (
      pointsOver (1_m, 0.0, [] (double x, double) { return 0.05 + 0.01 * x * x; }));
  for (const double x : {-1.0, -0.5, 0.0, 0.5})
    scene.addPlane (
        ground, 0.0, [x] (const auto& at) { return at.x() >= x && at.x() < x + 0.5; });
  join (scene);
  EXPECT_EQ (scene.planesWithLeaves(), 1u);
}

TEST (LeafJoining, LeavesPlanesApartThatAStepDivides)
{
  EXPECT_EQ (planesOfGroundAnd (anotherGround (2.0, 4_cm), 3_mm), 2u);
  EXPECT_EQ (planesOfGroundAnd (anotherGround (2.0, 0.0), 3_mm), 1u);
}

TEST (LeafJoining, LeavesPlanesApartThatASharpStepDividesWithinTheirNoise)
{
  // A wavy ground: from leaf to leaf it scatters by 5 mm, about its plane by 2 cm. Half
  // of it lies as high as the other or 3 cm higher.
  for (const double step : {0_cm, 3_cm}) {
    LeafScene scene (pointsOver (1_m,
                                 8.7e-3,
                                 [step] (double x, double y) {
                                   return 0.15 + 0.03 * std::sin (2.0 * pi * y) +
                                          (x < 0.0 ? 0.0 : step);
                                 }),
                     1_cm);
    scene.addPlane (ground, 0.0, before (0.0));
    scene.addPlane (ground, 0.0, behind (0.0));
    JoiningParameters parameters = usualJoining();
    parameters.joins_over_gaps = false;
    join (scene, parameters);
    EXPECT_EQ (scene.planesWithLeaves(), step > 0.0 ? 2u : 1u);
  }
}

TEST (LeafJoining, LeavesPlanesApartThatMeetAtACrease)
{
  const Surface slope = {{2, 0, 0.05}, {2, 0, 0.5}, {0, 2, 0}};
  EXPECT_EQ (planesOfGroundAnd (slope, 5_mm), 2u);
}

TEST (LeafJoining, MakesOnePlaneOfWhatGoesOnBehindAGap)
{
  EXPECT_EQ (planesOfGroundAnd (anotherGround (3.0, 0.0), 5_mm), 1u);
  EXPECT_EQ (planesOfGroundAnd (anotherGround (3.0, 5_cm), 5_mm), 2u) << "5 cm higher";
  const Surface slope = {{3, 0, 0.05}, {2, 0, 0.6}, {0, 2, 0}};
  EXPECT_EQ (planesOfGroundAnd (slope, 5_mm), 2u) << "another angle";
}

TEST (LeafJoining, OverGapsMayBeOffAndHasLimits)
{
  JoiningParameters parameters = usualJoining();
  parameters.joins_over_gaps = false;
  EXPECT_EQ (planesOfGroundAnd (anotherGround (3.0, 0.0), 5_mm, parameters), 2u);
  EXPECT_EQ (planesOfGroundAnd (anotherGround (2.0, 0.0), 5_mm, parameters), 1u)
      << "they touch";
  parameters.joins_over_gaps = true;
  parameters.max_distance_over_gaps = 100.0;
  EXPECT_EQ (planesOfGroundAnd (anotherGround (3.0, 5_cm), 5_mm, parameters), 1u);
  const Surface slope = {{3, 0, 0.05}, {2, 0, 0.05}, {0, 2, 0}};
  EXPECT_EQ (planesOfGroundAnd (slope, 5_mm, parameters), 1u);
  parameters.max_angle_over_gaps = 0.5_deg;
  EXPECT_EQ (planesOfGroundAnd (slope, 5_mm, parameters), 2u);
}

TEST (LeafJoining, GivesASmallPieceToThePlaneThatEnclosesIt)
{
  // A tile 9 mm above a ground of 2.9 mm of noise: of 30 cm x 60 cm with ground on all
  // sides, or on one side and leaves without a plane on the others; or a third of all.
  const struct {
    double width, ground_ends;
    std::size_t planes;
  } rows[] = {{0.3, 2.0, 1}, {0.3, 1.2, 2}, {0.8, 2.0, 2}};
  for (const auto& row : rows) {
    const auto isTile = [&row] (const auto& at) {
      return at.x() > 1.2 && at.x() < 1.2 + row.width && at.y() > 0.4 &&
             at.y() < 0.4 + 2.0 * row.width;
    };
    Coordinates points = gridsOf ({ground}, 120, 5_mm);
    for (std::size_t i = 0; i < points.size(); ++i)
      if (isTile (points[i]))
        points.z[i] += 0.009f;
    LeafScene scene (points, 3_mm);
    scene.addPlane (ground, 0.0, before (row.ground_ends));
    scene.addPlane (ground, 0.0, isTile);
    JoiningParameters parameters = usualJoining();
    parameters.joins_over_gaps = false;
    join (scene, parameters);
    EXPECT_EQ (scene.planesWithLeaves(), row.planes) << row.width;
  }
}

TEST (LeafJoining, TakesANarrowStripOfAnyAngle)
{
  // Between ground and wall, tilted by 8 degrees: of so narrow a strip that says
  // little.
  const Surface strip = {{1.9, 0, 0.05 - 7e-3}, {0.1, 0, 14e-3}, {0, 2, 0}};
  const Surface tall_wall = {{2.05, 0, -1}, {0, 2, 0}, {0, 0, 2}};
  Coordinates points = gridsOf ({{{0, 0, 0.05}, {1.9, 0, 0}, {0, 2, 0}}}, 114, 1_cm);
  addGrid (points, strip, 30, 1_cm);
  addGrid (points, tall_wall, 120, 1_cm);
  LeafScene scene (points, 6_mm);
  scene.addPlane (ground, 0.0, before (1.9));
  scene.addPlane (
      strip, 0.0, [] (const auto& at) { return at.x() > 1.9 && at.x() < 2.0; });
  scene.addPlane (tall_wall, 0.0, behind (2.0));
  join (scene);
  EXPECT_EQ (scene.planesWithLeaves(), 2u);
  EXPECT_EQ (scene.planes.plane_of_leaf[scene.leafAt ({1.95, 1.05, 0.05})],
             scene.planes.plane_of_leaf[scene.leafAt ({0.55, 1.05, 0.05})]);
}

TEST (LeafJoining, DoesNotExplainAStepByTheNoiseOfOneOfTwo)
{
  // A bush of 2 cm of noise beside a clean ground, and 3 cm above it.
  Coordinates points = gridsOf ({ground}, 120, 2_mm);
  addGrid (points, anotherGround (3.0, 3_cm), 120, 3.5e-2);
  LeafScene scene (points, 1_cm);
  scene.addPlane (ground, 0.0, before (2.5));
  scene.addPlane (anotherGround (3.0, 3_cm), 0.0, behind (2.5));
  join (scene);
  EXPECT_EQ (scene.planesWithLeaves(), 2u);
}

TEST (LeafJoining, JoinsNothingWhereThereIsNothing)
{
  LeafScene scene ({ground});
  join (scene);
  EXPECT_EQ (scene.planesWithLeaves(), 0u);
}
