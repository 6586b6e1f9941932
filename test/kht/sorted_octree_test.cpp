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
  EXPECT_EQ (root.centre, Eigen::Vector3d (2, 2, 2));
  EXPECT_EQ (root.edge, 2.0);
  EXPECT_NEAR (root.radius, std::sqrt (3.0), 1e-6);
}

TEST (RootCube, HasNoEdgeForNoPoints)
{
  EXPECT_EQ (rootCubeOf (Coordinates()).edge, 0.0);
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
  EXPECT_TRUE (octree.node (1, 1).centre.isApprox (Eigen::Vector3d (2.5, 1.5, 1.5)));
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
