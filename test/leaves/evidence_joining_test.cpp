// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "leaf_scene.h"
#include "leaves/evidence_joining.h"
#include "leaves/leaf_noise.h"

#include <algorithm>

using namespace pcl_ops::internal;

namespace {

/** \brief Joins the planes of a scene, and returns which changed. */
std::vector<char>
joinIn (LeafScene& scene)
{
  refitPlanes (scene.cloud, scene.planes);
  measureNoise (scene.cloud, 1, scene.planes);
  const auto surfels = orientLeaves (scene.cloud, scene.planes, {30.0, 4}, 1);
  return joinByEvidence (scene.cloud, surfels, 1, scene.planes);
}

bool
isInTheMiddle (const Eigen::Vector3d& at)
{
  return std::abs (at.x() - 1.1) < 0.1 && std::abs (at.y() - 1.1) < 0.1;
}

} // namespace

TEST (EvidenceJoining, JoinsTheHalvesOfABoardThatSags)
{
  // By 1.6 cm at its edges: each half is turned by 4.6 degrees against the other one,
  // where it goes on.
  LeafScene scene (
      pointsOver (40_cm, 1_cm, [] (double x, double) { return 0.05 + 0.1 * x * x; }));
  scene.addPlane (ground, 0.0, before (0.0));
  scene.addPlane (ground, 0.0, behind (0.0));
  EXPECT_EQ (joinIn (scene), (std::vector<char>{1, 1}));
  EXPECT_EQ (std::max (scene.leavesOn (0), scene.leavesOn (1)), scene.cloud.size());
}

TEST (EvidenceJoining, GivesATinyPieceOfAFloorBackToIt)
{
  LeafScene scene ({ground}, 5_mm);
  scene.addPlane (ground, 0.0, anywhere);
  scene.addPlane (ground, 0.0, isInTheMiddle);
  joinIn (scene);
  EXPECT_EQ (std::max (scene.leavesOn (0), scene.leavesOn (1)), scene.cloud.size());
}

TEST (EvidenceJoining, LeavesThePlateOnAFloorAlone)
{
  // Too small to be kept, but no part of what lies 8 cm below.
  Coordinates points = gridsOf ({ground}, 120, 5_mm);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (isInTheMiddle ({points.x[i], points.y[i], 0.0}))
      points.z[i] += 8_cm;
  LeafScene scene (points);
  scene.addPlane (ground, 0.0, anywhere);
  scene.addPlane (ground, 0.0, isInTheMiddle);
  EXPECT_EQ (joinIn (scene), (std::vector<char>{0, 0}));
}

TEST (EvidenceJoining, LeavesTheFacetsOfACylinderApart)
{
  LeafScene scene (pointsOver (
      1_m, 2_mm, [] (double x, double) { return std::sqrt (1.1 * 1.1 - x * x); }));
  for (const double x : {-1.0, -0.6, -0.2, 0.2, 0.6})
    scene.addPlane (
        ground, 0.0, [x] (const auto& at) { return at.x() >= x && at.x() < x + 0.4; });
  EXPECT_EQ (joinIn (scene), std::vector<char> (5, 0));
}

TEST (EvidenceJoining, LeavesPlanesThatAreKeptToOtherStages)
{
  LeafScene scene ({ground}, 5_mm);
  scene.addPlane (ground, 0.0, before (1.0));
  scene.addPlane (ground, 0.0, behind (1.0));
  EXPECT_EQ (joinIn (scene), (std::vector<char>{0, 0}));
}
