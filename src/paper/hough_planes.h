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
  /** \brief Indices of its clusters, ascending. */
  std::vector<std::uint32_t> clusters;
};

/** \brief What a cluster's votes count: 0.75 of its edge's share of the root's edge and
 * 0.25 of its points' share of all points. */
double
clusterWeight (const CoplanarCluster& cluster, const OctreeClusters& found);

/** \brief The planes that clusters agree on: each votes in an accumulator ball around
 * the cloud's centroid, and peaks are planes (Limberger & Oliveira 2015, sections 3.2
 * to 3.4), at their bins' centers, by the falling sum of their clusters' weights; they
 * share clusters. */
std::vector<HoughPlane>
voteForPlanes (const OctreeClusters& found, int phi_num, int rho_num);

/** \brief Gives each cluster to one plane and fits the planes to the points of theirs.
 * The plane with the largest weight of free clusters is fitted to them, takes all free
 * clusters whose rms distance to it is at most half of theta_h and is fitted again, so
 * that clusters too small for a good normal go to the large plane they lie on.
 * \param[in] min_share planes whose clusters hold less of all points are dropped
 * \param[in] distance_threshold theta_h [m]
 * \return the planes in the order they took clusters; they share none */
std::vector<HoughPlane>
refitPlanes (const std::vector<HoughPlane>& planes,
             const OctreeClusters& found,
             double min_share,
             double distance_threshold);

} // namespace pcl_ops::internal
