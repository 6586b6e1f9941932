// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/common/angles.h>
#include <pcl/PointIndices.h>

#include <io/shifted_cloud.h>
#include <pcl_ops/plane.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_ops::evaluation {

using apps::XyzCloud;

/** \brief The plane of each point of a cloud; 0: on no plane. */
using PlaneLabels = std::vector<std::uint32_t>;

/** \brief Labels 1 .. P of the points of disjoint planes. */
PlaneLabels
labelsOf (const std::vector<pcl::PointIndices>& planes, std::size_t points);

/** \brief Labels renumbered without gaps, so that a plane is an index into a vector. */
struct PlaneIds {
  /** \brief The labels in use, ascending, without 0. */
  std::vector<std::uint32_t> label;
  /** \brief Number of points of each plane. */
  std::vector<std::size_t> points;
  /** \brief Position in \ref label of each point's plane; none for label 0. */
  std::vector<std::uint32_t> of_point;

  static constexpr std::uint32_t none = ~std::uint32_t (0);

  std::size_t
  size () const
  {
    return label.size();
  }
};

PlaneIds
planeIds (const PlaneLabels& labels);

/** \brief Sets the labels of planes with fewer than \p min_points points to 0: the
 * paper's "small planes, with under 50 points, are labeled as other" (section IV-A). */
void
dropSmallPlanes (PlaneLabels& labels, std::size_t min_points);

/** \brief Below which the paper takes directions for the same: 7 degrees [rad]. */
const double paper_angle = pcl::deg2rad (7.0);

/** \brief How planes are divided into the paper's three classes. */
struct ClassParameters {
  /** \brief Unit vector against gravity in the cloud's frame. */
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  /** \brief Largest deviation from horizontal or vertical [rad]. */
  double tolerance = paper_angle;
};

/** \brief The planes of labeled points: least squares through all points of a label,
 * normals to the sensor's side.
 * \param[in] cloud finite points with the sensor's origin
 * \param[in] planes ids of their labels
 * \return a plane per id; class Other where the points of a label span none */
std::vector<PlaneSegment>
planesOf (const XyzCloud& cloud,
          const PlaneIds& planes,
          const ClassParameters& parameters);

} // namespace pcl_ops::evaluation
