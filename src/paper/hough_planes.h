// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "paper/octree_clusters.h"
#include <pcl_ops/plane.h>

#include <cstdint>
#include <vector>

namespace pcl_ops::internal {

/** \brief A plane and the clusters that voted for it. */
struct HoughPlane {
  Plane plane;
  /** \brief Indices of its clusters in OctreeClusters::clusters, ascending. */
  std::vector<std::uint32_t> clusters;
};

/** \brief Returns the weight of a cluster's votes, 0 to 1: 0.75 times the edge of its
 * node over the edge of the root, plus 0.25 times the share of all points that it has
 * (Limberger & Oliveira 2015). */
double
clusterWeight (const CoplanarCluster& cluster, const OctreeClusters& octree);

/** \brief Finds planes by a Hough transform: each cluster votes in an accumulator ball
 * around the center of the root, and each peak is a plane (Limberger & Oliveira 2015,
 * sections 3.2 to 3.4).
 * \param[in] phi_num steps of the accumulator from pole to pole
 * \param[in] rho_num steps of the accumulator from its center to the farthest of the
 * points in the root cube (RootCube::radius)
 * \return planes at the centers of their bins, by descending sum of the weights of
 * their clusters; planes may share clusters */
std::vector<HoughPlane>
voteForPlanes (const OctreeClusters& octree, int phi_num, int rho_num);

/** \brief Gives each cluster to at most one plane and fits the planes to the points of
 * their clusters. A cluster is free until a plane takes it. The plane whose free
 * clusters weigh most comes next: it is fitted to these clusters. Then, twice, it is
 * fitted anew to all free clusters whose rms distance to it is at most theta_h / 2, and
 * takes those of the last fit. So clusters too small for a good normal go to the large
 * plane they lie on.
 * \param[in] min_share planes whose clusters hold a smaller share of all points are
 * dropped, and their clusters remain free
 * \param[in] distance_threshold theta_h [m]
 * \return the planes in the order they took clusters; no two share a cluster */
std::vector<HoughPlane>
refitPlanes (const std::vector<HoughPlane>& planes,
             const OctreeClusters& octree,
             double min_share,
             double distance_threshold);

} // namespace pcl_ops::internal
