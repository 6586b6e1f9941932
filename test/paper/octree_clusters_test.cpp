// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "grid_scene.h"
#include "paper/octree_clusters.h"

using namespace pcl_ops::internal;

namespace {

// Rectangles that span 2 m along x and y, or along y and z.
const Surface tilted{{0.0, 0.0, 0.0}, {2.0, 0.0, 1.0}, {0.0, 2.0, 0.5}};
const Surface horizontal{{0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, {0.0, 2.0, 0.0}};
const Surface vertical{{0.0, 0.0, 0.0}, {0.0, 2.0, 0.0}, {0.0, 0.0, 2.0}};

/** Center of the octree node that a cluster is of. */
Eigen::Vector3d
nodeCenterOf (const RootCube& root, const CoplanarCluster& cluster)
{
  const Eigen::Vector3d corner =
      root.center - Eigen::Vector3d::Constant (root.edge / 2.0);
  const Eigen::Vector3d nodes_from_corner =
      (cluster.fit.centroid - corner) / cluster.edge;
  return corner + cluster.edge * (nodes_from_corner.array().floor() + 0.5).matrix();
}

/** The clusters from a first level on, with all other parameters as published. */
OctreeClusters
clustersOf (const Coordinates& points, int first_level)
{
  OctreeClusterParameters parameters;
  parameters.first_level = first_level;
  return findCoplanarClusters (points, parameters);
}

/** Fails unless a cluster has points of one octree node, their count and centroid, and
 * the normal of the tilted surface. */
void
expectClusterOfOneNode (const OctreeClusters& octree,
                        const CoplanarCluster& cluster,
                        const Coordinates& points)
{
  // Normals of small nodes, from level 4 on, have larger errors.
  const double max_angle = cluster.level > 3 ? 0.1 : 0.02; // [rad]
  EXPECT_LT (angleBetween (cluster.fit.plane.normal, tilted.normal()), max_angle);
  const Eigen::Vector3d center = nodeCenterOf (octree.root, cluster);
  constexpr double rounding = 1e-5; // [m]
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::uint32_t i = cluster.begin; i < cluster.end; ++i) {
    sum += points[octree.points[i].index];
    EXPECT_LE ((octree.points[i].position() - center).cwiseAbs().maxCoeff(),
               cluster.edge / 2.0 + rounding);
  }
  EXPECT_EQ (cluster.moments.count, cluster.size());
  EXPECT_LT ((cluster.fit.centroid - sum / cluster.size()).norm(), 1e-6);
}

/** The corners of a cube with an edge of 2 m and the center (2, 2, 2). */
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

TEST (RootCube, IsTheCubeOfThePointsWithoutAPointFarAway)
{
  constexpr float center_of_cube = 2.0f;
  for (const float coordinate : {center_of_cube, 20.0f, 1e6f, -1e6f, -1e38f}) {
    Coordinates points = cornersOfACube();
    points.add (coordinate, coordinate, coordinate);
    const RootCube root = rootCubeOf (points);
    EXPECT_EQ (root.center, Eigen::Vector3d (2, 2, 2)) << coordinate;
    EXPECT_EQ (root.edge, 2.0) << coordinate;
    EXPECT_NEAR (root.radius, std::sqrt (3.0), 1e-6) << coordinate;
  }
}

TEST (RootCube, HoldsAPointThatIsNotFarAwayAndAnyPointBesideEqualOnes)
{
  Coordinates points = cornersOfACube(), nearly_all_equal;
  points.add (4.5f, 2.0f, 2.0f); // 1.5 m from a face of the cube, which is 2 m wide
  EXPECT_TRUE (rootCubeOf (points).holds ({4.5, 2.0, 2.0}));
  for (int i = 0; i < 1000; ++i)
    nearly_all_equal.add (0.0f, 0.0f, 0.0f);
  nearly_all_equal.add (3.0f, 4.0f, 0.0f); // 5 m from the others
  EXPECT_NEAR (rootCubeOf (nearly_all_equal).radius, 5.0, 0.01);
}

TEST (RootCube, HoldsTwoWallsWhosePointsTakeTurns)
{
  RandomGenerator generator (seedOfTest());
  Coordinates points;
  for (int i = 0; i < 12000; ++i)
    points.add (i % 2 == 0 ? 0.0f : 10.0f,
                static_cast<float> (2.0 * drawUnit (generator)),
                static_cast<float> (2.0 * drawUnit (generator)));
  const RootCube root = rootCubeOf (points);
  EXPECT_TRUE (root.holds ({0.0, 1.0, 1.0}));
  EXPECT_TRUE (root.holds ({10.0, 1.0, 1.0}));
}

TEST (RootCube, OfOnePointIsThatPoint)
{
  Coordinates point;
  point.add (1.0f, 2.0f, 3.0f);
  const RootCube root = rootCubeOf (point);
  EXPECT_EQ (root.center, Eigen::Vector3d (1, 2, 3));
  EXPECT_EQ (root.edge, 0.0);
}

TEST (OctreeClusters, HoldThePointsOfOneNodeAndTheirPlane)
{
  // Nodes down to level 5 are sorted together, those below one by one.
  const Coordinates points = gridsOf ({tilted}, 400, 1_mm);
  for (const int first_level : {3, 5, 6}) {
    SCOPED_TRACE (first_level);
    const OctreeClusters octree = clustersOf (points, first_level);
    ASSERT_GT (octree.clusters.size(), 20u);
    for (const CoplanarCluster& cluster : octree.clusters)
      expectClusterOfOneNode (octree, cluster, points);
  }
}

TEST (OctreeClusters, AreDisjointRangesOfPointsThatHoldEachPointOnce)
{
  const Coordinates points = gridsOf ({horizontal, vertical}, 100, 2_mm);
  const OctreeClusters octree = clustersOf (points, 4);
  ASSERT_GT (octree.clusters.size(), 4u);
  for (std::size_t c = 1; c < octree.clusters.size(); ++c)
    EXPECT_LE (octree.clusters[c - 1].end, octree.clusters[c].begin);
  EXPECT_EQ (octree.points.size(), points.size());
  std::vector<bool> is_found (points.size(), false);
  for (const OctreePoint& point : octree.points) {
    EXPECT_EQ (point.position(), points[point.index]);
    is_found[point.index] = true;
  }
  EXPECT_EQ (std::count (is_found.begin(), is_found.end(), false), 0);
}

TEST (OctreeClusters, HoldPointsOfOneOfTwoPlanesThatMeet)
{
  const OctreeClusters octree = clustersOf (gridsOf ({horizontal, vertical}, 200), 2);
  ASSERT_GT (octree.clusters.size(), 4u);
  for (const CoplanarCluster& cluster : octree.clusters) {
    const double to_horizontal =
        angleBetween (cluster.fit.plane.normal, horizontal.normal());
    const double to_vertical =
        angleBetween (cluster.fit.plane.normal, vertical.normal());
    EXPECT_LT (std::min (to_horizontal, to_vertical), 0.1) << "[rad]";
  }
}

TEST (OctreeClusters, OfANarrowStripAreSeveral)
{
  // Ten times as long as wide: more than s_beta allows for a single cluster.
  const Surface strip{{0.0, 0.0, 0.0}, {4.0, 0.0, 0.0}, {0.0, 0.4, 0.0}};
  EXPECT_GT (clustersOf (gridsOf ({strip}, 100), 0).clusters.size(), 1u);
}

TEST (OctreeClusters, LeaveOutPointsFarFromTheirPlaneAndOutsideTheRoot)
{
  Coordinates with_points_above = gridsOf ({horizontal}, 100), with_stray_point;
  const Surface above{{0.0, 0.0, 1.0}, {0.1, 0.0, 0.0}, {0.0, 0.1, 0.0}};
  addGrid (with_points_above, above, 3);
  with_stray_point.add (1e6f, 1e6f, 0.0f);
  addGrid (with_stray_point, horizontal, 100);
  for (const Coordinates& all : {with_points_above, with_stray_point}) {
    const OctreeClusters octree = clustersOf (all, 0);
    ASSERT_EQ (octree.clusters.size(), 1u);
    EXPECT_EQ (octree.clusters[0].size(), 10000u);
    EXPECT_LT (octree.clusters[0].fit.variances[0], 1e-12);
    EXPECT_EQ (octree.points.size(), all.size()) << "the points of no cluster, too";
  }
}

TEST (OctreeClusters, BeginAtTheFirstLevelAndHaveAtLeast30Points)
{
  const Coordinates points = gridsOf ({horizontal}, 400);
  // 25 points, below the default min_samples.
  Coordinates few = gridsOf ({horizontal}, 5);
  for (const int first_level : {0, 2, 5, 6}) {
    const OctreeClusters octree = clustersOf (points, first_level);
    EXPECT_FALSE (octree.clusters.empty()) << first_level;
    for (const CoplanarCluster& cluster : octree.clusters) {
      EXPECT_EQ (cluster.level, first_level);
      EXPECT_GE (cluster.size(), 30u);
    }
  }
  EXPECT_TRUE (clustersOf (few, 0).clusters.empty());
  addGrid (few, horizontal, 4); // 41 points
  EXPECT_FALSE (clustersOf (few, 0).clusters.empty());
}

TEST (OctreeClusters, OfManyEqualPointsEndAtTheLargestMaxLevel)
{
  Coordinates points = gridsOf ({horizontal}, 10);
  for (int i = 0; i < 1000; ++i)
    points.add (1.0f, 1.0f, 1.0f);
  OctreeClusterParameters parameters;
  parameters.max_level = 60;
  const OctreeClusters octree = findCoplanarClusters (points, parameters);
  EXPECT_EQ (octree.points.size(), points.size()) << "it ends and loses no point";
  for (const CoplanarCluster& cluster : octree.clusters)
    EXPECT_LE (cluster.level, 60);
}
