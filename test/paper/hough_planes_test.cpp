// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "grid_scene.h"
#include "paper/hough_planes.h"

#include <set>

namespace {

using namespace pcl_ops;
using namespace pcl_ops::internal;

constexpr double cluster_threshold = 5_cm; // theta_h

const Surface bottom{{0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, {0.0, 2.0, 0.0}};
const Surface wall{{0.0, 0.0, 0.1}, {0.0, 2.0, 0.0}, {0.0, 0.0, 1.9}};
/** \brief Has 20 x 20 of the 20,400 points of the corner. */
const Surface shelf{{1.5, 0.5, 1.0}, {0.4, 0.0, 0.0}, {0.0, 0.4, 0.0}};

/** \brief Clusters of a corner: bottom, wall and shelf.
 * \param[in] max_offset of points along the normal, as in \ref addGrid [m] */
OctreeClusters
clustersOfCorner (double max_offset)
{
  Coordinates points = gridsOf ({bottom, wall}, 100, max_offset);
  addGrid (points, shelf, 20, max_offset);
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
  constexpr double share_of_edge = 2.0 / 8.0;
  constexpr double share_of_points = 100.0 / 1000.0;
  EXPECT_DOUBLE_EQ (clusterWeight (cluster, found),
                    0.75 * share_of_edge + 0.25 * share_of_points);
}

TEST (HoughPlanes, ComeByFallingWeight)
{
  constexpr int phi_num = 45, rho_num = 200;
  const OctreeClusters found = clustersOfCorner (1_mm);
  double previous_weight = INFINITY;
  for (const HoughPlane& plane : voteForPlanes (found, phi_num, rho_num)) {
    double weight = 0.0;
    for (const std::uint32_t cluster : plane.clusters)
      weight += clusterWeight (found.clusters[cluster], found);
    EXPECT_LE (weight, previous_weight + 1e-12);
    previous_weight = weight;
  }
}

TEST (HoughPlanes, ShareNoClusterWhenRefitted)
{
  constexpr int phi_num = 30, rho_num = 100;
  const OctreeClusters found = clustersOfCorner (1_cm);
  std::vector<HoughPlane> voted = voteForPlanes (found, phi_num, rho_num);
  for (std::size_t i = 0, size = voted.size(); i < size; ++i)
    voted.push_back (HoughPlane (voted[i])); // as if two peaks were of one surface
  constexpr double no_min_share = 0.0;
  std::set<std::uint32_t> taken;
  for (const HoughPlane& plane :
       refitPlanes (voted, found, no_min_share, cluster_threshold))
    for (const std::uint32_t cluster : plane.clusters)
      EXPECT_TRUE (taken.insert (cluster).second);
}

TEST (HoughPlanes, AreDroppedBelowTheSmallestShare)
{
  constexpr int phi_num = 30, rho_num = 100;
  const OctreeClusters found = clustersOfCorner (1_mm);
  const std::vector<HoughPlane> voted = voteForPlanes (found, phi_num, rho_num);
  constexpr double share_of_shelf = 400.0 / 20400.0;
  for (const double min_share : {0.5 * share_of_shelf, 2.0 * share_of_shelf}) {
    const std::vector<HoughPlane> planes =
        refitPlanes (voted, found, min_share, cluster_threshold);
    const auto isShelf = [] (const HoughPlane& plane) {
      return isNear (plane.plane, shelf, 1_deg, 1_cm);
    };
    EXPECT_EQ (std::any_of (planes.begin(), planes.end(), isShelf),
               min_share < share_of_shelf);
  }
}
