// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause

// Plane map of lidar odometry: C. Yuan, W. Xu, X. Liu, X. Hong & F. Zhang, "Efficient
// and Probabilistic Adaptive Voxel Mapping for Accurate Online LiDAR Odometry", RA-L
// 2022, section III-B. A voxel is a plane if the smallest eigenvalue of the covariance
// of its points is below a threshold. Other voxels are divided into eight, down to some
// layer. In the paper each voxel keeps its own plane; here mergePlanes joins the planes
// of one surface, so that the result can be compared with other detectors.
#include "peers.h"
#include <pcl_ops/plane_merging.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace pcl_ops::evaluation {

namespace {

// Chosen by hand; each layer has voxels of half the edge of the layer before.
constexpr int layers = 4;
constexpr std::size_t min_points_of_voxel = 5;
/** As for the region growing of PCL and of CGAL. */
constexpr std::size_t min_points_of_plane = 50;

struct OctreeParameters {
  double edge = 1.0; // of the largest voxels [m]
  /** A voxel is a plane if the smallest eigenvalue of the covariance of its points,
   * which is their mean squared distance to it, is below this bound [m^2]. */
  double max_eigenvalue = 0.01;
};

OctreeParameters
parametersFor (const PeerTask& task)
{
  OctreeParameters parameters;
  if (task.source == ValuesFrom::Tutorial)
    return parameters;
  // Edges of 0.5 to 3 m as in the paper. Within these limits the edge of the smallest
  // voxels is the gap, which is at least four times the point spacing, so that a plane
  // has about 16 points in such a voxel. Its rms distance may be up to twice the noise.
  constexpr double smallest_edge = 0.5;
  constexpr double largest_edge = 3.0;
  parameters.edge = std::clamp (
      task.values.gap * std::pow (2.0, layers - 1), smallest_edge, largest_edge);
  parameters.max_eigenvalue = std::pow (2.0 * task.values.noise, 2);
  return parameters;
}

struct VoxelOctree {
  const XyzCloud& cloud;
  double max_eigenvalue; // see OctreeParameters
  /** Moments and point indices of each voxel that is a plane. */
  std::vector<Moments> moments = {};
  std::vector<pcl::Indices> points = {};

  /** Adds a voxel if it is a plane, else those of its parts, in all further layers,
   * that are planes.
   * \param[in] members indices of the points in the voxel
   * \param[in] layer 0 for the largest voxels */
  void
  addPlanesIn (const pcl::Indices& members,
               const Vector3d& center,
               double edge,
               int layer)
  {
    if (members.size() < min_points_of_voxel)
      return;
    Moments sums;
    sums.origin = center;
    // Bit i of the index: above the center on axis i.
    std::array<pcl::Indices, 8> octants;
    for (const pcl::index_t i : members) {
      const Vector3d point = cloud[i].getVector3fMap().cast<double>();
      addTo (sums, point);
      const Eigen::Array<bool, 3, 1> is_above = (point - center).array() > 0.0;
      octants[is_above[0] + 2 * is_above[1] + 4 * is_above[2]].push_back (i);
    }
    const std::optional<PlaneFit> fit = fitPlane (sums);
    if (fit && fit->variances[0] < max_eigenvalue) {
      moments.push_back (sums);
      points.push_back (members);
      return;
    }
    for (int octant = 0; layer + 1 < layers && octant < 8; ++octant) {
      const Eigen::Array3d bits (octant & 1, octant >> 1 & 1, octant >> 2 & 1);
      const Vector3d offset = 0.5 * edge * (bits - 0.5);
      addPlanesIn (octants[octant], center + offset, 0.5 * edge, layer + 1);
    }
  }
};

} // namespace

Planes
planesInVoxelOctree (const PeerTask& task)
{
  const OctreeParameters parameters = parametersFor (task);
  const double edge = parameters.edge;
  std::map<std::array<int, 3>, pcl::Indices> voxels;
  for (std::size_t i = 0; i < task.cloud->size(); ++i) {
    std::array<int, 3> voxel{};
    for (int axis = 0; axis < 3; ++axis)
      voxel[axis] = int (std::floor ((*task.cloud)[i].data[axis] / edge));
    voxels[voxel].push_back (pcl::index_t (i));
  }
  VoxelOctree octree{*task.cloud, parameters.max_eigenvalue};
  for (const auto& [voxel, points] : voxels) {
    const Eigen::Array3d corner (voxel[0], voxel[1], voxel[2]);
    octree.addPlanesIn (points, edge * (corner + 0.5), edge, 0);
  }
  MergingParameters merging;
  merging.distance_threshold = task.values.threshold;
  const MergedPlanes merged = mergePlanes (octree.moments, merging);
  Planes planes (merged.moments.size());
  for (std::size_t i = 0; i < octree.points.size(); ++i)
    if (merged.merged_into[i] != no_plane) {
      pcl::Indices& plane = planes[std::size_t (merged.merged_into[i])].indices;
      plane.insert (plane.end(), octree.points[i].begin(), octree.points[i].end());
    }
  const std::size_t min_points = task.minPoints (min_points_of_plane);
  while (!planes.empty() && planes.back().indices.size() < min_points)
    planes.pop_back(); // planes are sorted by falling size
  return planes;
}

} // namespace pcl_ops::evaluation
