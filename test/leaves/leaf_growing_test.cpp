// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "leaf_scene.h"
#include "leaves/leaf_growing.h"

using pcl_ops::no_plane;
using namespace pcl_ops::internal;

namespace {

/** \brief The surface of the ground that goes on 2 m farther, some way up. */
Surface
groundHigherBy (double height)
{
  return {{2, 0, 0.05 + height}, {2, 0, 0}, {0, 2, 0}};
}

bool
onNoLeaf (const Eigen::Vector3d&)
{
  return false;
}

} // namespace

TEST (LeafGrowing, GoesOnRingByRing)
{
  for (const int rings : {1, 3, 50}) {
    LeafScene scene ({ground});
    scene.addPlane (ground, 6_mm, before (0.1));
    growPlanes (scene.cloud, 3.0, rings, 1, scene.planes);
    EXPECT_EQ (scene.leavesOn (0), 20u * std::min (20, 1 + rings));
  }
}

TEST (LeafGrowing, GivesALeafToTheNearerOfThePlanesNextToIt)
{
  // Next to the step of 1 cm either plane could take it, at 1.67 times the noise.
  for (const double row : {1.9, 2.0}) {
    LeafScene scene ({ground, groundHigherBy (1_cm)});
    scene.addPlane (ground, 6_mm, before (2.0));
    scene.addPlane (groundHigherBy (1_cm), 6_mm, behind (2.0));
    scene.label (no_plane, 0.0, [row] (const auto& at) {
      return std::abs (at.x() - row - 0.05) < 0.04;
    });
    EXPECT_EQ (scene.leavesOn (no_plane), 20u);
    growPlanes (scene.cloud, 3.0, 50, 1, scene.planes);
    EXPECT_EQ (scene.leavesOn (0), 400u);
    EXPECT_EQ (scene.leavesOn (1), 400u);
  }
}

TEST (LeafGrowing, TakesLeavesUpToADistanceInUnitsOfTheNoise)
{
  // What lies beyond the ground is on no plane.
  const struct {
    double height, noise, max_distance;
    std::size_t leaves;
  } rows[] = {{4_cm, 6_mm, 3.0, 400},
              {1_cm, 3_mm, 3.0, 400},
              {1_cm, 4_mm, 3.0, 800},
              {1_cm, 3_mm, 4.0, 800}};
  for (const auto& row : rows) {
    LeafScene scene ({ground, groundHigherBy (row.height)});
    scene.addPlane (ground, row.noise, before (1.5));
    growPlanes (scene.cloud, row.max_distance, 50, 1, scene.planes);
    EXPECT_EQ (scene.leavesOn (0), row.leaves) << row.height;
    EXPECT_EQ (scene.leavesOn (no_plane), 800 - row.leaves) << row.height;
  }
}

TEST (LeafGrowing, SaysWhichPlanesGrew)
{
  LeafScene scene ({ground, wall});
  scene.addPlane (ground, 6_mm, [] (const auto& at) { return at.x() > 1.0; });
  scene.addPlane (wall, 6_mm, [] (const auto& at) { return at.z() > 0.1; });
  EXPECT_EQ (growPlanes (scene.cloud, 3.0, 1, 1, scene.planes),
             (std::vector<char>{1, 0}))
      << "the corner is on neither";
}

TEST (LeafGrowing, GivesLeavesTheNoiseOfThePlaneThere)
{
  LeafScene scene ({ground});
  scene.addPlane (ground, 6_mm, before (0.1));
  growPlanes (scene.cloud, 3.0, 50, 1, scene.planes);
  for (const double noise : scene.planes.noise)
    EXPECT_DOUBLE_EQ (noise, 6_mm);
}

TEST (LeafRelaxing, MovesLeavesToTheLikelierPlane)
{
  // The first row of the higher ground is on the plane of the lower one.
  LeafScene scene ({ground, groundHigherBy (4_cm)});
  scene.addPlane (ground, 2_cm, before (2.1));
  scene.addPlane (groundHigherBy (4_cm), 2_cm, behind (2.1));
  EXPECT_EQ (relaxLabels (scene.cloud, 1, scene.planes), (std::vector<char>{1, 1}));
  EXPECT_EQ (scene.leavesOn (0), 400u);
  EXPECT_EQ (scene.leavesOn (1), 400u);
  EXPECT_TRUE (isNear (scene.planes.planes[0], ground, 1e-5, 1e-5)) << "fitted anew";
}

TEST (LeafRelaxing, MovesThemToTheLessNoisyOfTwoThatExplainThem)
{
  LeafScene scene ({ground});
  scene.addPlane (ground, 3_mm, before (1.0));
  scene.addPlane (ground, 5_cm, behind (1.0));
  relaxLabels (scene.cloud, 1, scene.planes);
  EXPECT_GT (scene.leavesOn (0), 260u) << "a row after the other";
}

TEST (LeafRelaxing, LeavesThemWhereNoOtherPlaneIsNear)
{
  // 10 cm from their own and 5 cm from the other plane, of a noise of 1 cm.
  LeafScene scene ({ground});
  scene.addPlane ({Eigen::Vector3d::UnitZ(), -0.10}, 1_cm, before (1.0));
  scene.addPlane ({Eigen::Vector3d::UnitZ(), -0.15}, 1_cm, behind (1.0));
  EXPECT_EQ (relaxLabels (scene.cloud, 1, scene.planes), (std::vector<char>{0, 0}));
  EXPECT_EQ (scene.leavesOn (1), 200u);
}

TEST (LeafRelaxing, GivesNoPlaneToLeavesWithoutOne)
{
  LeafScene scene ({ground});
  scene.addPlane (ground, 1_cm, before (1.0));
  scene.addPlane (ground, 1_cm, onNoLeaf);
  relaxLabels (scene.cloud, 1, scene.planes);
  EXPECT_EQ (scene.leavesOn (no_plane), 200u);
}
