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

/** \brief What the parameters of all detectors have in common. */
struct PlaneDetectorParameters {
  /** \brief theta_h: largest distance of a point to its plane [m], before the last fit
   * and merging. Not given, which only OPS but for Sampling::Points allows: it follows
   * the noise of the cloud, whatever its unit. */
  std::optional<double> distance_threshold = 0.05;
  /** \brief A plane with fewer points (inliers) than this is not returned, and its
   * points are on no plane; 0: no limit. */
  std::size_t min_points = 0;
  /** \brief Direction against gravity in the frame of the input cloud, any length but
   * 0. It names the orientation of a plane and turns normals that no sensor
   * decides (turnUnseenUp); else detection does not depend on it, except where planes
   * are looked for per orientation (Strategy::DivideThenDetect). */
  Eigen::Vector3f up_axis = Eigen::Vector3f::UnitZ();
  /** \brief Largest angle to be horizontal or vertical [rad]. */
  double angle_tolerance = paper_angle_tolerance;
  /** \brief Seed of every random choice. */
  std::uint32_t seed = 42;
  /** \brief Number of threads; 0: all. The result does not depend on it. */
  unsigned threads = 1;
  MergingParameters merging;
};

/** \brief What is wrong with the parameters all detectors share, as a sentence; empty
 * if nothing is. */
PCL_OPS_EXPORT std::string
validate (const PlaneDetectorParameters& parameters);

} // namespace pcl_ops
