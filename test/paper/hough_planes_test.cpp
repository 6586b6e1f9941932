// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "grid_scene.h"
#include "paper/hough_planes.h"

#include <set>

namespace {

using namespace pcl_ops;
using namespace pcl_ops::internal;

constexpr double theta_of_votes = 5_cm;

const Surface bottom{{0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, {0.0, 2.0, 0.0}};
const Surface wall{{0.0, 0.0, 0.1}, {0.0, 2.0, 0.0}, {0.0, 0.0, 1.9}};
const Surface shelf{{1.5, 0.5, 1.0}, {0.4, 0.0, 0.0}, {0.0, 0.4, 0.0}};

OctreeClusters
clustersOfCorner (double noise)
{
  Coordinates points = gridsOf ({bottom, wall}, 100, noise);
  addGrid (points, shelf, 20, noise);
  OctreeClusterParameters parameters;
  parameters.first_level = 3;
  return findCoplanarClusters (points, parameters);
}

} // namespace

TEST (HoughPlanes, WeighAClusterByItsEdgeAndPoints)
{
  OctreeClusters found;
  found.root.edge = 8.0;
  found.points.resize (1000);
  CoplanarCluster cluster;
  cluster.edge = 2.0;
  cluster.end = 100;
  EXPECT_DOUBLE_EQ (clusterWeight (cluster, found), 0.75 * 0.25 + 0.25 * 0.1);
}

TEST (HoughPlanes, ComeByFallingWeight)
{
  const OctreeClusters found = clustersOfCorner (1_mm);
  double before = INFINITY;
  for (const HoughPlane& plane : voteForPlanes (found, 45, 200)) {
    double weight = 0.0;
    for (const std::uint32_t cluster : plane.clusters)
      weight += clusterWeight (found.clusters[cluster], found);
    EXPECT_LE (weight, before + 1e-12);
    before = weight;
  }
}

TEST (HoughPlanes, ShareNoClusterWhenRefitted)
{
  const OctreeClusters found = clustersOfCorner (1_cm);
  std::vector<HoughPlane> voted = voteForPlanes (found, 30, 100);
  for (std::size_t i = 0, size = voted.size(); i < size; ++i)
    voted.push_back (HoughPlane (voted[i])); // as if two peaks were of one surface
  std::set<std::uint32_t> taken;
  for (const HoughPlane& plane : refitPlanes (voted, found, 0.0, theta_of_votes))
    for (const std::uint32_t cluster : plane.clusters)
      EXPECT_TRUE (taken.insert (cluster).second);
}

TEST (HoughPlanes, AreDroppedBelowTheSmallestShare)
{
  const OctreeClusters found = clustersOfCorner (1_mm);
  const std::vector<HoughPlane> voted = voteForPlanes (found, 30, 100);
  constexpr double share_of_shelf = 400.0 / 20400.0;
  for (const double share : {0.5, 2.0}) {
    const auto planes =
        refitPlanes (voted, found, share * share_of_shelf, theta_of_votes);
    const auto is_shelf = [] (const HoughPlane& plane) {
      return isNear (plane.plane, shelf, 1_deg, 1_cm);
    };
    EXPECT_EQ (std::any_of (planes.begin(), planes.end(), is_shelf), share < 1.0);
  }
}
