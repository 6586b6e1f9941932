// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <pcl_ops/cloud_view.h>
#include <pcl_ops/export.h>
#include <pcl_ops/plane.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace pcl_ops {

/** \brief When two planes meet. */
struct PlaneEdgeParameters {
  /** \brief Both planes must have points this near to the line that they have in common
   * [m]. Automatic: three times their rms, over the sine of the angle between them,
   * and four times the mean distance between neighboring points. */
  std::optional<double> reach;
  /** \brief Gaps between points along the line are bridged up to this length, and ends
   * up to this far from a corner are drawn to it [m]. Automatic: twice the reach. */
  std::optional<double> max_gap;
  /** \brief Shorter edges are left out, before ends are drawn to corners [m].
   * Automatic: three times the reach. */
  std::optional<double> min_length;
  /** \brief Two planes at a smaller angle have no edge, because noise moves their line
   * far [rad]. Three planes have no corner if one of them is at a smaller angle to the
   * edge of the other two. */
  double min_angle = 15.0 * (M_PI / 180.0);
};

/** \brief What is wrong with parameters, as a sentence; empty if nothing is. */
PCL_OPS_EXPORT std::string
validate (const PlaneEdgeParameters& parameters);

/** \brief An interval of the line that two planes have in common, with points of both
 * beside it. */
struct PlaneEdge {
  /** \brief Positions in the list of planes, ascending. */
  std::array<std::size_t, 2> planes{};
  /** \brief Its ends in the frame of the planes [m], in the direction of normal x
   * normal, in the order of \ref planes. */
  Eigen::Vector3d from = Eigen::Vector3d::Zero();
  Eigen::Vector3d to = Eigen::Vector3d::Zero();
  /** \brief Between the planes, 0 to pi/2 [rad]. */
  double angle = 0.0;

  /** \brief From end to end [m]. */
  double
  length () const
  {
    return (to - from).norm();
  }
};

/** \brief The point that three planes have in common, where each two have an edge. */
struct PlaneCorner {
  /** \brief Positions in the list of planes, ascending. */
  std::array<std::size_t, 3> planes{};
  /** \brief In the frame of the planes [m]. */
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
};

/** \brief Where planes meet; both lists in ascending order of their planes, edges of
 * the same two planes along their line. */
struct PlaneEdges {
  std::vector<PlaneEdge> edges;
  std::vector<PlaneCorner> corners;
};

/** \brief Where planes meet: edges of two, corners of three.
 *
 * Two planes n . x + d = 0 have the line along n1 x n2 through p, the point nearest to
 * the middle m of their centroids: p = m + a n1 + b n2 with [1 c; c 1] [a b]^T = -[h1
 * h2]^T, c = n1 . n2, and h1, h2 the distances of m to both planes (Goldman,
 * Intersection of two lines in three-space and of three planes, Graphics Gems, 1990).
 * An edge is an interval of it along which each of the two has inliers within reach, so
 * that a wall with a door has two on the floor, and a plane may end on the middle of
 * another. Three planes meet where [n1 n2 n3]^T x = -[d1 d2 d3]^T. That is a corner
 * where each two of them have an edge that comes so near that the gap is bridged; ends
 * of edges there are drawn to it. Places are exact 10^6 m from zero, too, whatever the
 * order of the inliers.
 * \param[in] cloud the input cloud the planes were found in
 * \param[in] planes as a detector gives them; those that are not finite meet none
 * \param[in] parameters ones \ref validate finds nothing wrong with
 * \param[in] shift zero of the cloud's frame in that of the planes: for planes that
 * were moved back to where single precision could not follow
 * \throw std::invalid_argument if there is a problem, or an inlier that is no point of
 * the cloud */
PCL_OPS_EXPORT PlaneEdges
findPlaneEdges (const CloudView& cloud,
                const std::vector<PlaneSegment>& planes,
                const PlaneEdgeParameters& parameters = PlaneEdgeParameters(),
                const Eigen::Vector3d& shift = Eigen::Vector3d::Zero());

} // namespace pcl_ops
