// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "grid_scene.h"
#include "kht/octree_clusters.h"

#include <algorithm>
#include <cmath>

using namespace pcl_ops::internal;

namespace {

const Surface tilted{{0.0, 0.0, 0.0}, {2.0, 0.0, 1.0}, {0.0, 2.0, 0.5}};
const Surface level{{0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, {0.0, 2.0, 0.0}};
const Surface upright{{0.0, 0.0, 0.0}, {0.0, 2.0, 0.0}, {0.0, 0.0, 2.0}};

/** Center of the octree leaf the cluster lies in. */
Eigen::Vector3d
cellCenterOf (const OctreeClusters& found, const CoplanarCluster& cluster)
{
  const Eigen::Vector3d corner =
      found.root.center - Eigen::Vector3d::Constant (found.root.edge / 2.0);
  const Eigen::Vector3d leaf = (cluster.fit.centroid - corner) / cluster.edge;
  return corner + cluster.edge * (leaf.array().floor() + 0.5).matrix();
}

OctreeClusters
clustersOf (const Coordinates& points, int first_level)
{
  OctreeClusterParameters parameters;
  parameters.first_level = first_level;
  return findCoplanarClusters (points, parameters);
}

} // namespace

TEST (OctreeClusters, HaveTheNormalOfTheirPlane)
{
  Coordinates points;
  addGrid (points, tilted, 100, 0.001);
  const OctreeClusters found = clustersOf (points, 3);
  ASSERT_GT (found.clusters.size(), 20u);
  for (const CoplanarCluster& cluster : found.clusters)
    EXPECT_LT (angleBetween (cluster.fit.plane.normal, tilted.normal()), 0.02);
}

TEST (OctreeClusters, HoldThePointsOfOneCell)
{
  Coordinates points;
  addGrid (points, tilted, 100);
  const OctreeClusters found = clustersOf (points, 3);
  constexpr double rounding = 1e-5;
  for (const CoplanarCluster& cluster : found.clusters) {
    const Eigen::Vector3d center = cellCenterOf (found, cluster);
    for (std::uint32_t i = cluster.begin; i < cluster.end; ++i)
      EXPECT_LE ((found.points[i] - center).cwiseAbs().maxCoeff(),
                 cluster.edge / 2.0 + rounding);
  }
}

TEST (OctreeClusters, ShareNoPoint)
{
  Coordinates points;
  addGrid (points, level, 100, 0.002);
  addGrid (points, upright, 100, 0.002);
  OctreeClusters found = clustersOf (points, 4);
  for (std::size_t c = 1; c < found.clusters.size(); ++c)
    EXPECT_LE (found.clusters[c - 1].end, found.clusters[c].begin);
  std::sort (found.points.order.begin(), found.points.order.end());
  for (std::size_t i = 0; i < points.size(); ++i)
    ASSERT_EQ (found.points.order[i], i) << "the order is a permutation of all points";
}

TEST (OctreeClusters, HaveTheMomentsOfTheirPoints)
{
  Coordinates points;
  addGrid (points, tilted, 60, 0.001);
  const OctreeClusters found = clustersOf (points, 3);
  for (const CoplanarCluster& cluster : found.clusters) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::uint32_t i = cluster.begin; i < cluster.end; ++i)
      sum += points[found.points.order[i]];
    EXPECT_EQ (cluster.moments.count, cluster.size());
    EXPECT_LT ((cluster.fit.centroid - sum / cluster.size()).norm(), 1e-6);
  }
}

TEST (OctreeClusters, AreCutWhereTwoPlanesMeet)
{
  Coordinates points;
  addGrid (points, level, 200);
  addGrid (points, upright, 200);
  const OctreeClusters found = clustersOf (points, 2);
  for (const CoplanarCluster& cluster : found.clusters) {
    const double to_floor = angleBetween (cluster.fit.plane.normal, level.normal());
    const double to_wall = angleBetween (cluster.fit.plane.normal, upright.normal());
    EXPECT_LT (std::min (to_floor, to_wall), 0.1);
  }
}

TEST (OctreeClusters, DropPointsFarFromTheirPlane)
{
  Coordinates points;
  addGrid (points, level, 100);
  addGrid (points, Surface{{0.0, 0.0, 1.0}, {0.1, 0.0, 0.0}, {0.0, 0.1, 0.0}}, 3);
  const OctreeClusters found = clustersOf (points, 0);
  ASSERT_EQ (found.clusters.size(), 1u);
  EXPECT_EQ (found.clusters[0].size(), 10000u);
  EXPECT_LT (found.clusters[0].fit.variances[0], 1e-12);
}

TEST (OctreeClusters, BeginAtTheFirstLevel)
{
  Coordinates points;
  addGrid (points, level, 200);
  for (const int first_level : {0, 2, 5, 6})
    for (const CoplanarCluster& cluster : clustersOf (points, first_level).clusters)
      EXPECT_EQ (cluster.level, first_level);
}

TEST (OctreeClusters, NeedTheMinimumOfSamples)
{
  Coordinates points;
  addGrid (points, level, 5);
  EXPECT_TRUE (clustersOf (points, 0).clusters.empty());
  addGrid (points, level, 4);
  EXPECT_FALSE (clustersOf (points, 0).clusters.empty());
}

TEST (OctreeClusters, EndAtManyEqualPointsOnTheDeepestLevelThereMayBe)
{
  Coordinates points;
  addGrid (points, level, 10);
  for (int i = 0; i < 1000; ++i)
    points.add (1.0f, 1.0f, 1.0f);
  OctreeClusterParameters parameters;
  parameters.max_level = 60;
  for (const CoplanarCluster& cluster :
       findCoplanarClusters (points, parameters).clusters)
    EXPECT_LE (cluster.level, 60);
}
