// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "grid_scene.h"
#include "paper/octree_clusters.h"

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

/** Fails unless a cluster's points lie in one octree leaf and on the tilted surface. */
void
expectPointsOfOneCell (const OctreeClusters& found,
                       const CoplanarCluster& cluster,
                       const Coordinates& points)
{
  // Normals of small cells err by more.
  const double max_angle = cluster.level > 3 ? 0.1 : 0.02; // [rad]
  EXPECT_LT (angleBetween (cluster.fit.plane.normal, tilted.normal()), max_angle);
  const Eigen::Vector3d center = cellCenterOf (found, cluster);
  constexpr double rounding = 1e-5;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::uint32_t i = cluster.begin; i < cluster.end; ++i) {
    sum += points[found.points[i].index];
    EXPECT_LE ((found.points[i].position() - center).cwiseAbs().maxCoeff(),
               cluster.edge / 2.0 + rounding);
  }
  EXPECT_EQ (cluster.moments.count, cluster.size());
  EXPECT_LT ((cluster.fit.centroid - sum / cluster.size()).norm(), 1e-6);
}

/** The corners of a cube of 2 m around (2, 2, 2). */
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

TEST (RootCube, HoldsAllPointsAroundTheirCentroidButForOneFarAway)
{
  constexpr float middle = 2.0f;
  for (const float coordinate : {middle, 20.0f, 1e6f, -1e6f, -1e38f}) {
    Coordinates points = cornersOfACube();
    points.add (coordinate, coordinate, coordinate);
    const RootCube root = rootCubeOf (points);
    EXPECT_EQ (root.center, Eigen::Vector3d (2, 2, 2)) << coordinate;
    EXPECT_EQ (root.edge, 2.0) << coordinate;
    EXPECT_NEAR (root.radius, std::sqrt (3.0), 1e-6) << coordinate;
  }
}

TEST (RootCube, HoldsAPointThatIsNotFarAwayAndAllPointsWhereNearlyAllAreEqual)
{
  Coordinates points = cornersOfACube(), equal;
  points.add (4.5f, 2.0f, 2.0f);
  EXPECT_TRUE (rootCubeOf (points).holds ({4.5, 2.0, 2.0}));
  for (int i = 0; i < 1000; ++i)
    equal.add (0.0f, 0.0f, 0.0f);
  equal.add (3.0f, 4.0f, 0.0f);
  EXPECT_NEAR (rootCubeOf (equal).radius, 5.0, 0.01);
}

TEST (RootCube, OfOnePointIsThatPoint)
{
  Coordinates point;
  point.add (1.0f, 2.0f, 3.0f);
  const RootCube root = rootCubeOf (point);
  EXPECT_EQ (root.center, Eigen::Vector3d (1, 2, 3));
  EXPECT_EQ (root.edge, 0.0);
}

TEST (OctreeClusters, HoldThePointsOfOneCellOnTheirPlane)
{
  // Cells down to level 5 are sorted together, those below one by one.
  const Coordinates points = gridsOf ({tilted}, 400, 0.001);
  for (const int first_level : {3, 5, 6}) {
    SCOPED_TRACE (first_level);
    const OctreeClusters found = clustersOf (points, first_level);
    ASSERT_GT (found.clusters.size(), 20u);
    for (const CoplanarCluster& cluster : found.clusters)
      expectPointsOfOneCell (found, cluster, points);
  }
}

TEST (OctreeClusters, ShareNoPoint)
{
  const Coordinates points = gridsOf ({level, upright}, 100, 0.002);
  const OctreeClusters found = clustersOf (points, 4);
  for (std::size_t c = 1; c < found.clusters.size(); ++c)
    EXPECT_LE (found.clusters[c - 1].end, found.clusters[c].begin);
  std::vector<bool> is_found (points.size(), false);
  for (const OctreePoint& point : found.points) {
    EXPECT_EQ (point.position(), points[point.index]);
    is_found[point.index] = true;
  }
  EXPECT_EQ (std::count (is_found.begin(), is_found.end(), false), 0);
}

TEST (OctreeClusters, AreCutWhereTwoPlanesMeet)
{
  const OctreeClusters found = clustersOf (gridsOf ({level, upright}, 200), 2);
  for (const CoplanarCluster& cluster : found.clusters) {
    const double to_floor = angleBetween (cluster.fit.plane.normal, level.normal());
    const double to_wall = angleBetween (cluster.fit.plane.normal, upright.normal());
    EXPECT_LT (std::min (to_floor, to_wall), 0.1);
  }
}

TEST (OctreeClusters, AreNoNarrowStrips)
{
  const Surface strip{{0.0, 0.0, 0.0}, {4.0, 0.0, 0.0}, {0.0, 0.4, 0.0}};
  EXPECT_GT (clustersOf (gridsOf ({strip}, 100), 0).clusters.size(), 1u);
}

TEST (OctreeClusters, DropPointsFarFromTheirPlaneAndOutsideTheirRoot)
{
  Coordinates with_points_above = gridsOf ({level}, 100), with_stray_point;
  addGrid (
      with_points_above, Surface{{0.0, 0.0, 1.0}, {0.1, 0.0, 0.0}, {0.0, 0.1, 0.0}}, 3);
  with_stray_point.add (1e6f, 1e6f, 0.0f);
  addGrid (with_stray_point, level, 100);
  for (const Coordinates& all : {with_points_above, with_stray_point}) {
    const OctreeClusters found = clustersOf (all, 0);
    ASSERT_EQ (found.clusters.size(), 1u);
    EXPECT_EQ (found.clusters[0].size(), 10000u);
    EXPECT_LT (found.clusters[0].fit.variances[0], 1e-12);
    EXPECT_EQ (found.points.size(), all.size()) << "they are still there";
  }
}

TEST (OctreeClusters, BeginAtTheFirstLevelWithTheMinimumOfSamples)
{
  Coordinates points = gridsOf ({level}, 200), few = gridsOf ({level}, 5);
  for (const int first_level : {0, 2, 5, 6})
    for (const CoplanarCluster& cluster : clustersOf (points, first_level).clusters)
      EXPECT_EQ (cluster.level, first_level);
  EXPECT_TRUE (clustersOf (few, 0).clusters.empty());
  addGrid (few, level, 4);
  EXPECT_FALSE (clustersOf (few, 0).clusters.empty());
}

TEST (OctreeClusters, EndAtManyEqualPointsOnTheDeepestLevelThereMayBe)
{
  Coordinates points = gridsOf ({level}, 10);
  for (int i = 0; i < 1000; ++i)
    points.add (1.0f, 1.0f, 1.0f);
  OctreeClusterParameters parameters;
  parameters.max_level = 60;
  for (const CoplanarCluster& cluster :
       findCoplanarClusters (points, parameters).clusters)
    EXPECT_LE (cluster.level, 60);
}
