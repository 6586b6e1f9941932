// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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

/** \brief Indices of the points of a cloud that have coordinates. */
pcl::Indices
finitePointsOf (const XyzCloud& cloud);

/** \brief The labels of some of the points. */
PlaneLabels
selectLabels (const PlaneLabels& labels, const pcl::Indices& points);

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

/** \brief Adds a point in the frame of the origin of the moments. */
inline void
addTo (Moments& moments, const Eigen::Vector3d& point)
{
  const Eigen::Vector3d local = point - moments.origin;
  moments.add (local.x(), local.y(), local.z());
}

/** \brief How planes are divided into the paper's three classes. */
struct ClassParameters {
  /** \brief Unit vector against gravity in the cloud's frame. */
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  /** \brief Largest deviation from horizontal or vertical [rad]. */
  double tolerance = paper_angle_tolerance;
};

/** \brief The planes of labeled points: least squares through all points of a label,
 * normals to the sensor's side.
 * \param[in] cloud finite points with the sensor's origin
 * \return a plane per id; class Other where the points of a label span none */
std::vector<PlaneSegment>
planesOf (const XyzCloud& cloud,
          const PlaneIds& planes,
          const ClassParameters& parameters);

/** \brief Number of points a true plane and a found plane have in common. */
struct Overlap {
  std::uint32_t truth, result;
  std::size_t points;
};

/** \brief How two labelings of the same points meet: only pairs that do are stored. */
struct Confusion {
  PlaneIds truth, result;
  /** \brief By truth, then by result; ids as in \ref truth and \ref result. */
  std::vector<Overlap> overlaps = {};
  std::size_t points_on_no_plane_in_both = 0;
  /** \brief Points on no true plane. */
  std::size_t points_off_planes = 0;

  /** \brief Intersection over union of the two planes of an overlap. */
  double
  iou (const Overlap& overlap) const
  {
    const std::size_t both =
        truth.points[overlap.truth] + result.points[overlap.result] - overlap.points;
    return static_cast<double> (overlap.points) / static_cast<double> (both);
  }
};

/** \param[in] truth, result labels of the same points: of equal size */
Confusion
confusionOf (const PlaneLabels& truth, const PlaneLabels& result);

} // namespace pcl_ops::evaluation
