// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "grid_scene.h"
#include "paper/hough_planes.h"

#include <set>

namespace {

using namespace pcl_ops;
using namespace pcl_ops::internal;

// Number of points along each edge of a surface.
constexpr int steps_of_bottom_and_wall = 100;
constexpr int steps_of_shelf = 20;

const Surface bottom{{0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, {0.0, 2.0, 0.0}};
const Surface wall{{0.0, 0.0, 0.1}, {0.0, 2.0, 0.0}, {0.0, 0.0, 1.9}};
const Surface shelf{{1.5, 0.5, 1.0}, {0.4, 0.0, 0.0}, {0.0, 0.4, 0.0}};

constexpr std::size_t surfaces_of_corner = 3;

/** \brief Clusters of a corner of bottom, wall and shelf.
 * \param[in] max_offset largest distance of a point from its surface [m] */
OctreeClusters
clustersOfCorner (double max_offset)
{
  Coordinates points = gridsOf ({bottom, wall}, steps_of_bottom_and_wall, max_offset);
  addGrid (points, shelf, steps_of_shelf, max_offset);
  OctreeClusterParameters parameters;
  parameters.first_level = 3;
  return findCoplanarClusters (points, parameters);
}

} // namespace

TEST (HoughPlanes, WeighAClusterByItsEdgeAndPoints)
{
  OctreeClusters octree;
  octree.root.edge = 8.0;
  octree.points.resize (1000);
  CoplanarCluster cluster;
  cluster.edge = 2.0;
  cluster.begin = 0;
  cluster.end = 100;
  constexpr double share_of_edge = 2.0 / 8.0;
  constexpr double share_of_points = 100.0 / 1000.0;
  EXPECT_DOUBLE_EQ (clusterWeight (cluster, octree),
                    0.75 * share_of_edge + 0.25 * share_of_points);
}

TEST (HoughPlanes, AreOrderedByFallingWeight)
{
  constexpr int phi_num = 45, rho_num = 200;
  const OctreeClusters octree = clustersOfCorner (1_mm);
  const std::vector<HoughPlane> voted = voteForPlanes (octree, phi_num, rho_num);
  EXPECT_GE (voted.size(), surfaces_of_corner);
  double previous_weight = INFINITY;
  for (const HoughPlane& plane : voted) {
    double weight = 0.0;
    for (const std::uint32_t cluster : plane.clusters)
      weight += clusterWeight (octree.clusters[cluster], octree);
    EXPECT_GT (weight, 0.0);
    constexpr double rounding = 1e-12;
    EXPECT_LE (weight, previous_weight + rounding);
    previous_weight = weight;
  }
}

TEST (HoughPlanes, ShareNoClusterWhenRefitted)
{
  constexpr int phi_num = 30, rho_num = 100;
  const OctreeClusters octree = clustersOfCorner (1_cm);
  std::vector<HoughPlane> voted = voteForPlanes (octree, phi_num, rho_num);
  EXPECT_GE (voted.size(), surfaces_of_corner);
  // Each plane twice, as if each surface had two peaks.
  for (std::size_t i = 0, size = voted.size(); i < size; ++i)
    voted.push_back (HoughPlane (voted[i]));
  constexpr double no_min_share = 0.0;
  std::set<std::uint32_t> taken_clusters;
  for (const HoughPlane& plane : refitPlanes (voted, octree, no_min_share, theta_h))
    for (const std::uint32_t cluster : plane.clusters)
      EXPECT_TRUE (taken_clusters.insert (cluster).second);
  EXPECT_FALSE (taken_clusters.empty());
}

TEST (HoughPlanes, AreDroppedBelowTheMinimumShareOfPoints)
{
  constexpr int phi_num = 30, rho_num = 100;
  const OctreeClusters octree = clustersOfCorner (1_mm);
  const std::vector<HoughPlane> voted = voteForPlanes (octree, phi_num, rho_num);
  constexpr double points_of_shelf = steps_of_shelf * steps_of_shelf;
  constexpr double points_of_others =
      2.0 * steps_of_bottom_and_wall * steps_of_bottom_and_wall;
  constexpr double share_of_shelf =
      points_of_shelf / (points_of_others + points_of_shelf);
  for (const double min_share : {0.5 * share_of_shelf, 2.0 * share_of_shelf}) {
    const std::vector<HoughPlane> planes =
        refitPlanes (voted, octree, min_share, theta_h);
    const auto isShelf = [] (const HoughPlane& plane) {
      return isNear (plane.plane, shelf, 1_deg, 1_cm);
    };
    EXPECT_EQ (std::any_of (planes.begin(), planes.end(), isShelf),
               min_share < share_of_shelf);
  }
}
