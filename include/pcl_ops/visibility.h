// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <pcl_ops/cloud_view.h>
#include <pcl_ops/export.h>
#include <pcl_ops/plane.h>

#include <vector>

namespace pcl_ops {

namespace detail {

/** \brief Returns the share of the points that lie in directions, seen from a
 * viewpoint, in which one surface occludes another: there points are at clearly
 * different ranges. If the cloud was taken from the viewpoint, the share is about 0.03,
 * because of the edges of objects. If not, it is 0.1 to 0.3: for example if the cloud
 * is in a world frame but VIEWPOINT is 0 0 0.
 * \param[in] cloud a sample of up to some 60,000 finite points is used; the order of
 * the points does not matter
 * \param[in] viewpoint in the frame of the cloud
 * \return 0 to 1; 0 if no direction has enough points or the viewpoint is not finite */
PCL_OPS_EXPORT double
occludedFraction (const CloudView& cloud, const Eigen::Vector3d& viewpoint);

} // namespace detail

/** \brief Returns whether a cloud may have been taken from a viewpoint.
 *
 * True if hardly any surface occludes another (\ref detail::occludedFraction up to
 * 0.01). Otherwise it is decided by the directions to the points, which have even steps
 * if the sensor was at the viewpoint. If the steps tell nothing, as in a thinned cloud,
 * the result is true for an occluded fraction of up to 0.05. In lidar scans positions 3
 * m beside the sensor are rejected; a position above it may be accepted. A cloud of
 * several scans has no single viewpoint. False if \p viewpoint is not finite. */
PCL_OPS_EXPORT bool
isSeenFrom (const Eigen::Vector3d& viewpoint, const CloudView& cloud);

/** \brief Flips normals that point down if it is not known from which side the planes
 * were seen. Normals of vertical planes do not change.
 *
 * It flips normals of all planes if the cloud was not taken from the viewpoint, or if
 * the viewpoint is farther away than 500 times the size of the scene: maps and surveys
 * have no sensor position. Otherwise it flips only normals of planes seen edge-on: the
 * distance of the viewpoint to the plane is less than 2 % of its distance to the
 * centroid, as for the floor of a map. Detectors call it if the viewpoint is 0 0 0.
 * \param[in] cloud the input cloud of the detection
 * \param[in] viewpoint to which normals point, in the frame of cloud and planes
 * \param[in] up against gravity, of any length but 0
 * \param[in,out] planes with orientations for \p up; only their normals change */
PCL_OPS_EXPORT void
turnUnseenUp (const CloudView& cloud,
              const Eigen::Vector3d& viewpoint,
              const Eigen::Vector3d& up,
              std::vector<PlaneSegment>& planes);

/** \brief Calls \ref isSeenFrom with the sensor_origin_ of a cloud. */
template <typename PointT>
bool
isSeenFromItsOrigin (const pcl::PointCloud<PointT>& cloud)
{
  const Eigen::Vector3f origin = cloud.sensor_origin_.template head<3>();
  return isSeenFrom (origin.template cast<double>(), CloudView (cloud));
}

} // namespace pcl_ops
