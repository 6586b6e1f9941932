// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/common/angles.h>

#include "labels.h"
#include <io/xyz_cloud.h>
#include <pcl_ops/plane.h>

namespace pcl_ops::evaluation {

using apps::XyzCloud;

/** \brief Below which the paper takes directions for the same: 7 degrees [rad].
 */
const double paper_angle = pcl::deg2rad (7.0);

/** \brief How planes are divided into the paper's three classes. */
struct ClassParameters {
  /** \brief Unit vector against gravity in the cloud's frame. */
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  /** \brief Largest deviation from horizontal or vertical [rad]. */
  double tolerance = paper_angle;
};

/** \brief The planes of labelled points: least squares through all points of a label,
 * normals to the sensor's side, without \ref PlaneSegment::inliers.
 * \param[in] cloud finite points with the sensor's origin
 * \param[in] planes ids of their labels
 * \return a plane per id; class Other where the points of a label span none */
std::vector<PlaneSegment>
planesOf (const XyzCloud& cloud,
          const PlaneIds& planes,
          const ClassParameters& parameters);

/** \brief The class of each point: that of its label's plane.
 * \return Other for label 0 and where the points of a label span no plane */
std::vector<Orientation>
pointClasses (const XyzCloud& cloud,
              const PlaneLabels& labels,
              const ClassParameters& parameters);

} // namespace pcl_ops::evaluation
