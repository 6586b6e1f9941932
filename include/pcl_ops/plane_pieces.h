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

/** \brief Parameters of \ref findPlanePieces. */
struct PlanePiecesParameters {
  /** \brief Widest gap within a piece, in units of the spacing of the points at its two
   * sides; the smaller spacing counts.
   *
   * The spacing at a point is that in the sparser direction on the plane: in a lidar
   * scan it is the distance to the next scan line, not to the next point of the line.
   */
  double max_gap = 8.0;
  /** \brief Smallest number of points of a piece: smaller pieces are joined to the
   * nearest one. */
  std::size_t min_points = 20;
};

/** \brief Returns the first problem of the parameters; empty if they are valid. */
PCL_OPS_EXPORT std::string
validate (const PlanePiecesParameters& parameters);

/** \brief Connected pieces of planes, by descending number of inliers. */
struct PlanePieces {
  /** \brief Each piece has its own inliers, centroid and moments, and the normal and
   * the orientation of its plane. The centroid is projected onto that plane. */
  std::vector<PlaneSegment> pieces;
  /** \brief For each piece, the index of its plane in the list of planes. */
  std::vector<std::size_t> planes;
};

/** \brief Divides planes at gaps between their points into connected components: for
 * example two tables of one height. A plane without gaps is one piece, unchanged. If a
 * plane is divided, each finite inlier is in one piece, and others in none.
 * \param[in] cloud the input cloud of the detection, in the frame of the planes
 * \param[in] planes the planes that a detector returned
 * \param[in] parameters must be valid (\ref validate)
 * \param[in] threads 0: one for each processor; the result does not depend on it
 * \throw std::invalid_argument if an inlier is not an index into the cloud or the
 * parameters are wrong */
PCL_OPS_EXPORT PlanePieces
findPlanePieces (const CloudView& cloud,
                 const std::vector<PlaneSegment>& planes,
                 const PlanePiecesParameters& parameters = PlanePiecesParameters(),
                 unsigned threads = 1);

} // namespace pcl_ops
