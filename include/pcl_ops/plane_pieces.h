// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/cloud_view.h>
#include <pcl_ops/export.h>
#include <pcl_ops/plane.h>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl_ops {

struct PlanePiecesParameters {
  /** \brief Widest gap within a piece, as a multiple of the spacing of the points on
   * either side of it, the smaller one where they differ.
   *
   * The spacing at a point is that of its neighbors along the wider direction on the
   * plane: rings of a lidar are as far apart as the next ring, not as the next point of
   * the ring. */
  double max_gap = 8.0;
  /** \brief Fewer points are no piece of their own, but part of the nearest one. */
  std::size_t min_points = 20;
};

/** \brief What is wrong with these parameters, as a sentence; empty if nothing is. */
PCL_OPS_EXPORT std::string
validate (const PlanePiecesParameters& parameters);

/** \brief Connected pieces of planes, by falling size. */
struct PlanePieces {
  /** \brief Each piece has inliers, centroid and moments of its own, and the normal and
   * the orientation of the plane it lies on; the centroid is taken onto that plane. */
  std::vector<PlaneSegment> pieces;
  /** \brief For each piece the position of the plane it lies on. */
  std::vector<std::size_t> planes;
};

/** \brief Divides planes where their points leave gaps: windows of a facade, two tables
 * of one height. Each inlier is in one piece, but for those that are not finite; a
 * plane without a gap is its only piece, as it is.
 * \param[in] cloud the one the planes were found in, in their frame
 * \param[in] planes as a detector gives them
 * \param[in] parameters ones \ref validate finds nothing wrong with
 * \param[in] threads 0: all; the result stays the same
 * \throw std::invalid_argument if an inlier lies outside the cloud or the parameters are
 * wrong */
PCL_OPS_EXPORT PlanePieces
findPlanePieces (const CloudView& cloud,
                 const std::vector<PlaneSegment>& planes,
                 const PlanePiecesParameters& parameters = PlanePiecesParameters(),
                 unsigned threads = 1);

} // namespace pcl_ops
