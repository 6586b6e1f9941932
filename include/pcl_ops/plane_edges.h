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

/** \brief Conditions for two planes to have an edge. */
struct PlaneEdgeParameters {
  /** \brief Both planes must have points within this distance of their intersection
   * line [m]. Not given: 3 sqrt (rms1^2 + rms2^2) / sin (angle between the planes),
   * plus 4 times the larger mean distance between neighboring points. */
  std::optional<double> reach;
  /** \brief Longest gap between points along the line that is bridged. Also the largest
   * distance over which an end is moved to a corner [m]. Not given: twice the reach. */
  std::optional<double> max_gap;
  /** \brief Shorter edges are left out, before ends are moved to corners [m]. Not
   * given: three times the reach. */
  std::optional<double> min_length;
  /** \brief Two planes at a smaller angle have no edge, because noise would shift their
   * intersection line far [rad]. Three planes have no corner if one of them is at a
   * smaller angle to the intersection line of the other two. */
  double min_angle = 15.0 * (M_PI / 180.0);
};

/** \brief Returns the first problem of the parameters; empty if they are valid. */
PCL_OPS_EXPORT std::string
validate (const PlaneEdgeParameters& parameters);

/** \brief An interval of the intersection line of two planes that has points of both
 * planes beside it. */
struct PlaneEdge {
  /** \brief Indices of the planes in the list of planes, ascending. */
  std::array<std::size_t, 2> planes{};
  /** \brief Ends in the frame of the planes [m]. The edge points in the direction n1 x
   * n2 of the normals, in the order of \ref planes. */
  Eigen::Vector3d from = Eigen::Vector3d::Zero();
  Eigen::Vector3d to = Eigen::Vector3d::Zero();
  /** \brief Angle between the planes, 0 to pi/2 [rad]. */
  double angle = 0.0;

  /** \brief Returns the length [m]. */
  double
  length () const
  {
    return (to - from).norm();
  }
};

/** \brief The intersection point of three planes, any two of which have an edge. */
struct PlaneCorner {
  /** \brief Indices of the planes in the list of planes, ascending. */
  std::array<std::size_t, 3> planes{};
  /** \brief In the frame of the planes [m]. */
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
};

/** \brief Edges and corners, both sorted by the indices of their planes. Edges of the
 * same two planes are sorted along their line. */
struct PlaneEdges {
  std::vector<PlaneEdge> edges;
  std::vector<PlaneCorner> corners;
};

/** \brief Finds the edges of two planes and the corners of three planes.
 *
 * Two planes n . x + d = 0 intersect in a line along n1 x n2. It passes through p, its
 * point nearest to the middle m of both centroids: p = m + a n1 + b n2 with [1 c; c 1]
 * [a b]^T = -[h1 h2]^T, c = n1 . n2, and h1, h2 the distances of m to both planes
 * (Goldman, Intersection of two lines in three-space and of three planes, Graphics
 * Gems, 1990). An edge is an interval of this line along which both planes have inliers
 * within reach. So a wall with a door has two edges with the floor, and a plane may end
 * in the middle of another plane. Three planes intersect in a point with [n1 n2 n3]^T x
 * = -[d1 d2 d3]^T. The point is a corner if any two of the planes have an edge that
 * comes within max_gap of it. Ends of edges that near are moved to the corner.
 * Positions are exact 10^6 m from zero, too, and do not depend on the order of the
 * inliers.
 * \param[in] cloud the input cloud of the detection
 * \param[in] planes the planes that a detector returned; non-finite planes get no edges
 * \param[in] parameters must be valid (\ref validate)
 * \param[in] shift origin of the cloud's frame in the frame of the planes [m]: for
 * planes moved to coordinates too large for the single precision of the cloud
 * \throw std::invalid_argument if the parameters are wrong, or an inlier is not an
 * index into the cloud */
PCL_OPS_EXPORT PlaneEdges
findPlaneEdges (const CloudView& cloud,
                const std::vector<PlaneSegment>& planes,
                const PlaneEdgeParameters& parameters = PlaneEdgeParameters(),
                const Eigen::Vector3d& shift = Eigen::Vector3d::Zero());

} // namespace pcl_ops
