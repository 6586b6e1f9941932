// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/common/angles.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include "labels.h"
#include <pcl_ops/orientation.h>

namespace pcl_ops::evaluation {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

/** \brief How planes are divided into the paper's three classes. */
struct ClassParameters {
  /** \brief Unit vector against gravity in the cloud's frame. */
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  /** \brief Largest deviation from horizontal or vertical [rad]; the paper's 7 degrees.
   */
  double tolerance = pcl::deg2rad (7.0);
};

/** \brief The class of each point: that of the least squares plane through all points
 * of its label.
 * \return Other for label 0 and where the points of a label span no plane
 */
std::vector<Orientation>
pointClasses (const Cloud& cloud,
              const Labels& labels,
              const ClassParameters& parameters);

} // namespace pcl_ops::evaluation
