// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <pcl_ops/export.h>
#include <pcl_ops/orientation.h>
#include <pcl_ops/plane_merging.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace pcl_ops {

/** \brief The parameters that all detectors share. */
struct PlaneDetectorParameters {
  /** \brief theta_h: largest distance of a point to its plane [m], before the last fit
   * and merging. Not given: the distance follows the noise of the cloud, in any unit.
   * Every detector needs it except OPS without Sampling::Points, which does not set it
   * by default. */
  std::optional<double> distance_threshold = 0.05;
  /** \brief Smallest number of inliers of a plane. Smaller planes are dropped, and
   * their points are on no plane. 0: no limit. */
  std::size_t min_points = 0;
  /** \brief Direction against gravity in the frame of the input cloud, of any length
   * but 0. It decides the orientation of a plane, and the sign of its normal if the
   * sensor position is not known (turnUnseenUp). Only with Strategy::DivideThenDetect
   * it also decides which planes are found. */
  Eigen::Vector3f up_axis = Eigen::Vector3f::UnitZ();
  /** \brief Largest angle of a horizontal plane to the horizontal, and of a vertical
   * plane to the vertical [rad]. */
  double angle_tolerance = paper_angle_tolerance;
  /** \brief Seed of the random draws. Only FSPF and OPS with Sampling::Points draw at
   * random. */
  std::uint32_t seed = 42;
  /** \brief Number of threads; 0: one for each processor. The result does not depend
   * on it. */
  unsigned threads = 1;
  MergingParameters merging;
};

/** \brief Checks the parameters that all detectors share.
 * \return the first problem as a sentence; empty for valid parameters */
PCL_OPS_EXPORT std::string
validate (const PlaneDetectorParameters& parameters);

} // namespace pcl_ops
