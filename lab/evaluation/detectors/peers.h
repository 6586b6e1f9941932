// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "detectors.h"

namespace pcl_ops::evaluation {

/** Parameters that all peers have, each under a name of its own. */
struct PeerValues {
  double threshold; // largest distance of a point to its plane [m]
  int neighbors;    // number of points from which a normal is estimated
  double gap;       // points closer to each other are connected [m]
  double noise;     // standard deviation of the distances of points to their plane [m]
};

/** Source of parameters: the peers' tutorials, or noise and spacing of the cloud. */
enum class ValuesFrom { Tutorial, Cloud };

/** Returns parameters of peers. ValuesFrom::Tutorial takes the threshold of \p
 * settings. ValuesFrom::Cloud takes three times the noise as the threshold, as many
 * neighbors as make normals err by 3 degrees, and four times the point spacing as the
 * gap, all within limits. Neighbors that \p settings give replace those of both
 * sources. Noise that they give replaces that of the cloud. An empty cloud, and a cloud
 * most of whose points coincide, get the values of the tutorials. */
PeerValues
valuesFor (const XyzCloud::ConstPtr& cloud,
           const RunSettings& settings,
           ValuesFrom source);

/** Input of a peer detector. */
struct PeerTask {
  XyzCloud::ConstPtr cloud; // finite points
  const RunSettings& settings;
  PeerValues values;
  ValuesFrom source;       // where the values are from
  double& time_of_normals; // the detector adds the time of normal estimation [ms]

  /** Returns the number of points of the smallest plane to find.
   * \param[in] peer_default is returned if the settings give none */
  std::size_t
  minPoints (std::size_t peer_default) const
  {
    return settings.peer_min_points.value_or (peer_default);
  }
};

/** Points of each plane, as indices into PeerTask::cloud. */
using Planes = std::vector<pcl::PointIndices>;

/** SACSegmentation in the loop of PCL's tutorial, see \ref peelPlanes. */
Planes
planesByPclRansac (const PeerTask& task);

/** RegionGrowing. */
Planes
planesByPclRegionGrowing (const PeerTask& task);

/** OrganizedMultiPlaneSegmentation; needs RunSettings::image. */
Planes
planesInImage (const PeerTask& task);

/** Efficient RANSAC (Schnabel et al. 2007). */
Planes
planesByCgalRansac (const PeerTask& task);

/** Shape_detection::Region_growing. */
Planes
planesByCgalRegionGrowing (const PeerTask& task);

/** Open3D's segment_plane in the loop of PCL's tutorial, see \ref peelPlanes. */
Planes
planesByOpen3d (const PeerTask& task);

/** The adaptive voxel map of lidar odometry (Yuan et al. 2022). */
Planes
planesInVoxelOctree (const PeerTask& task);

/** Adds each peer twice: with the parameters of its tutorial in the group "peers", and
 * as NAME-measured with parameters from the cloud in the group "peers-measured". */
void
addPeers (std::vector<Configuration>& configurations);

/** The loop of PCL's tutorial: repeatedly removes the inliers of the largest plane.
 * It ends if that plane has fewer than 500 inliers (or the minimum of \p task), if at
 * most 2 % of the points are on no plane yet, or if 40 planes are found.
 * \param[in] segment returns the inliers of the largest plane among the points \p rest,
 * which are on no plane yet; both are ascending indices into the cloud */
Planes
peelPlanes (const PeerTask& task,
            const std::function<pcl::Indices (const pcl::IndicesPtr& rest)>& segment);

} // namespace pcl_ops::evaluation
