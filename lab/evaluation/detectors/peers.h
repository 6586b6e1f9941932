// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "detectors.h"

namespace pcl_ops::evaluation {

struct PeerValues {
  double threshold; // distance to a plane [m]
  int neighbors;    // that a normal is estimated from
  double gap;       // that does not divide a surface [m]
  double noise;     // standard deviation of the points of a plane [m]
};

/** As in the tutorials of the detectors, or from noise and distances of the points. */
enum class ValuesFrom { Tutorial, Cloud };

/** Where \p settings give none. From the cloud: a threshold of three times the noise;
 * neighbors so many that a normal errs by 3 degrees; gaps of four times the distance of
 * points. */
PeerValues
valuesFor (const XyzCloud::ConstPtr& cloud,
           const RunSettings& settings,
           ValuesFrom source);

struct PeerTask {
  XyzCloud::ConstPtr cloud; // finite points
  const RunSettings& settings;
  PeerValues values;
  ValuesFrom source;
  double& normals; // where their time is to be added [ms]

  std::size_t
  minPoints (std::size_t usual) const
  {
    return settings.peer_min_points.value_or (usual);
  }
};

using Planes = std::vector<pcl::PointIndices>;

/** The loop of PCL's tutorial around SACSegmentation. */
Planes
planesByPclRansac (const PeerTask& task);

Planes
planesByPclRegionGrowing (const PeerTask& task);

/** OrganizedMultiPlaneSegmentation, for images. */
Planes
planesInImage (const PeerTask& task);

/** Efficient RANSAC (Schnabel et al. 2007). */
Planes
planesByCgalRansac (const PeerTask& task);

Planes
planesByCgalRegionGrowing (const PeerTask& task);

/** The loop of PCL's tutorial around SegmentPlane. */
Planes
planesByOpen3d (const PeerTask& task);

/** As lidar odometry divides its map. */
Planes
planesInVoxelOctree (const PeerTask& task);

/** All of them twice: at the values of their tutorials in the group "peers", and at
 * those of the cloud as NAME-measured in "peers-measured". */
void
addPeers (std::vector<Configuration>& configurations);

/** The loop of PCL's tutorial: takes the largest plane away until fewer than 500 of the
 * points, or as \p task has it, are on it, 2 % are left, or 40 are found.
 * \param[in] segment gives those on the largest plane of some, both ascending */
Planes
peelPlanes (const PeerTask& task,
            const std::function<pcl::Indices (const pcl::IndicesPtr& rest)>& segment);

} // namespace pcl_ops::evaluation
