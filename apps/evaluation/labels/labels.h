// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/PointIndices.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_ops::evaluation {

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

/** \brief Renumbers labels 1 .. P by falling number of points, ties by label. */
void
sortBySize (PlaneLabels& labels);

} // namespace pcl_ops::evaluation
