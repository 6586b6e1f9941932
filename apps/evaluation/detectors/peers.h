// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "detectors.h"

namespace pcl_ops::evaluation {

/** \brief What the detectors of others are told about a cloud. */
struct PeerValues {
  /** \brief Of a point to the plane it belongs to [m]. */
  double threshold = usual_peer_threshold;
  /** \brief Whose points a normal is estimated from. */
  int neighbors = 30;
  /** \brief Gaps up to this do not divide a surface [m]. */
  double gap = 2.0 * usual_peer_threshold;
  /** \brief Standard deviation of the points of a plane [m]. */
  double noise = usual_peer_threshold / 3.0;
};

enum class ValuesFrom {
  /** \brief The same for every cloud, as in the tutorials of the detectors. */
  Tutorial,
  /** \brief The noise and the distances of the points of the cloud. */
  Cloud
};

/** \brief The values for a cloud, where \p settings give none. From the cloud: a
 * threshold of three times the noise; neighbors so many that a normal errs by 3
 * degrees; gaps of four times the distance of points.
 * \param[in] cloud finite points */
PeerValues
valuesFor (const XyzCloud::ConstPtr& cloud,
           const RunSettings& settings,
           ValuesFrom source);

/** \brief What a detector of others is given. */
struct PeerTask {
  /** \brief Finite points. */
  XyzCloud::ConstPtr cloud;
  const RunSettings& settings;
  PeerValues values;
  ValuesFrom source;
  /** \brief The time of normals is to be added here [ms]. */
  double& normals;
};

using DetectAsPeer = std::vector<pcl::PointIndices> (const PeerTask& task);

/** \brief The loop of PCL's tutorial around SACSegmentation. */
DetectAsPeer planesByPclRansac;
DetectAsPeer planesByPclRegionGrowing;
/** \brief OrganizedMultiPlaneSegmentation, for images. */
DetectAsPeer planesInImage;
/** \brief Efficient RANSAC (Schnabel et al. 2007). */
DetectAsPeer planesByCgalRansac;
DetectAsPeer planesByCgalRegionGrowing;
/** \brief The loop of PCL's tutorial around SegmentPlane. */
DetectAsPeer planesByOpen3d;
/** \brief As lidar odometry divides its map. */
DetectAsPeer planesInVoxelOctree;

/** \brief Adds all of them twice: at the values of their tutorials in the group
 * "peers", and at those of the cloud as NAME-measured in "peers-measured". */
void
addPeers (std::vector<Configuration>& configurations);

/** \brief The loop of PCL's tutorial: takes the largest plane away until fewer than 500
 * of the points are on it, 2 % are left, or 40 are found.
 * \param[in] points of the cloud
 * \param[in] segment gives those on the largest plane of some, both ascending */
std::vector<pcl::PointIndices>
peelPlanes (std::size_t points,
            const std::function<pcl::Indices (const pcl::IndicesPtr& rest)>& segment);

} // namespace pcl_ops::evaluation
