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

/** \brief Share of a cloud's points that share their direction, as seen from a place,
 * with points much nearer or farther: about 0.03 at the edges of things where a cloud
 * was taken from that place, 0.1 to 0.3 where it was not, say because it is in the
 * frame of a world and VIEWPOINT says 0 0 0 all the same.
 * \param[in] cloud some 60,000 finite points of it are looked at, whatever their order
 * \param[in] viewpoint the place, in the frame of the cloud
 * \return 0 to 1; 0 where no direction has points enough, or the place is not finite */
PCL_OPS_EXPORT double
occludedFraction (const CloudView& cloud, const Eigen::Vector3d& viewpoint);

} // namespace detail

/** \brief Whether a cloud may have been taken from a place.
 *
 * It was where directions to the points are in even steps, as a sensor makes them, also
 * if twigs and edges of the cloud hide one another. Where the steps tell nothing, as of
 * a thinned cloud, there has to be one surface in each direction, nothing behind
 * anything (\ref detail::occludedFraction up to 0.05). Of lidar scans places 3 m beside
 * the sensor are told from it, one above it may be believed. A cloud of several scans
 * was taken from no one place. */
PCL_OPS_EXPORT bool
isSeenFrom (const Eigen::Vector3d& viewpoint, const CloudView& cloud);

/** \brief Turns normals up where nothing says from which side the planes were seen. The
 * normals of vertical planes stay as they are.
 *
 * This concerns all planes of a cloud that was not taken from the place, or that the
 * place is 500 times as far away from as the planes reach, as maps and surveys that
 * have no sensor. It also concerns planes that pass the place at less than 2 % of the
 * distance of their points from it, as the floor of a map does. Detectors do so where a
 * cloud says 0 0 0.
 * \param[in] cloud the one the planes were found in
 * \param[in] viewpoint what normals point to, in the frame of cloud and planes
 * \param[in] up against gravity, of any length but 0
 * \param[in,out] planes their orientations are those for \p up; only their normals
 * change */
PCL_OPS_EXPORT void
turnUnseenUp (const CloudView& cloud,
              const Eigen::Vector3d& viewpoint,
              const Eigen::Vector3d& up,
              std::vector<PlaneSegment>& planes);

/** \brief \ref isSeenFrom for the sensor_origin_ of a cloud. */
template <typename PointT>
bool
isSeenFromItsOrigin (const pcl::PointCloud<PointT>& cloud)
{
  const Eigen::Vector3f origin = cloud.sensor_origin_.template head<3>();
  return isSeenFrom (origin.template cast<double>(), CloudView (cloud));
}

} // namespace pcl_ops
