// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "grid_scene.h"
#include "kht/sorted_octree.h"

using namespace pcl_ops::internal;

namespace {

Coordinates
cornersOfACube ()
{
  Coordinates points;
  for (const float z : {3.0f, 1.0f})
    for (const float y : {3.0f, 1.0f})
      for (const float x : {3.0f, 1.0f})
        points.add (x, y, z);
  return points;
}

} // namespace

TEST (RootCube, HoldsAllPointsAroundTheirCentroid)
{
  const RootCube root = rootCubeOf (cornersOfACube());
  EXPECT_EQ (root.center, Eigen::Vector3d (2, 2, 2));
  EXPECT_EQ (root.edge, 2.0);
  EXPECT_NEAR (root.radius, std::sqrt (3.0), 1e-6);
}

TEST (RootCube, IsThatOfAllOthersWhereOnePointIsFarAway)
{
  const RootCube alone = rootCubeOf (cornersOfACube());
  for (const float far : {20.0f, 1e6f, -1e38f}) {
    Coordinates points = cornersOfACube();
    points.add (far, far, far);
    const RootCube root = rootCubeOf (points);
    EXPECT_EQ (root.center, alone.center) << far;
    EXPECT_EQ (root.edge, alone.edge) << far;
    EXPECT_EQ (root.radius, alone.radius) << far;
  }
}

TEST (RootCube, HoldsAStepAsWideAsTheRest)
{
  Coordinates points = cornersOfACube();
  points.add (4.5f, 2.0f, 2.0f);
  EXPECT_TRUE (rootCubeOf (points).holds ({4.5, 2.0, 2.0}));
}

TEST (RootCube, HoldsAllPointsWhereNearlyAllAreEqual)
{
  Coordinates points;
  for (int i = 0; i < 1000; ++i)
    points.add (0.0f, 0.0f, 0.0f);
  points.add (3.0f, 4.0f, 0.0f);
  EXPECT_NEAR (rootCubeOf (points).radius, 5.0, 0.01);
}

TEST (SortedOctree, PutsPointsInTheOrderOfItsNodes)
{
  const Coordinates points = cornersOfACube();
  const SortedOctree octree = sortIntoOctree (points, rootCubeOf (points), 1);
  EXPECT_EQ (octree.points.order, (Indices{7, 6, 5, 4, 3, 2, 1, 0}))
      << "x first, z last, from low to high";
  EXPECT_EQ (octree.begins, (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5, 6, 7, 8}));
  EXPECT_EQ (octree.points.x[0], 1.0f);
  EXPECT_EQ (octree.points.x[1], 3.0f);
}

TEST (SortedOctree, HasNodesWithTheirPoints)
{
  const Coordinates points = cornersOfACube();
  const SortedOctree octree = sortIntoOctree (points, rootCubeOf (points), 1);
  EXPECT_EQ (octree.node (0, 0).size(), 8u);
  EXPECT_EQ (octree.node (0, 0).edge, 2.0);
  EXPECT_EQ (octree.node (1, 1).size(), 1u);
  EXPECT_EQ (octree.node (1, 1).edge, 1.0);
  EXPECT_TRUE (octree.node (1, 1).center.isApprox (Eigen::Vector3d (2.5, 1.5, 1.5)));
}

TEST (SortedOctree, HasNoNodeForAPointOutsideItsRoot)
{
  Coordinates points;
  points.add (1e6f, 1e6f, 1e6f);
  const Coordinates corners = cornersOfACube();
  for (std::size_t i = 0; i < corners.size(); ++i)
    points.add (corners.x[i], corners.y[i], corners.z[i]);
  const SortedOctree octree = sortIntoOctree (points, rootCubeOf (points), 1);
  EXPECT_EQ (octree.node (0, 0).size(), 8u);
  EXPECT_EQ (octree.points.size(), 9u) << "but it is still there";
  EXPECT_EQ (octree.points.order.back(), 0u);
}

TEST (PermutedPoints, SwapWithTheirPlacesBefore)
{
  PermutedPoints points;
  points.resize (2);
  points.x = {1, 2};
  points.order = {10, 20};
  points.swapPoints (0, 1);
  EXPECT_EQ (points.x, (std::vector<float>{2, 1}));
  EXPECT_EQ (points.order, (Indices{20, 10}));
}
