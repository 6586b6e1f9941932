// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud/points.h"
#include <pcl_ops/cloud_view.h>
#include <pcl_ops/plane_detector.h>

#include <array>
#include <cstdint>
#include <optional>

namespace pcl_ops::internal {

/** \brief The sampled points P_s with normals, in the local frame of Points. */
struct OrientedSamples : Coordinates {
  /** \brief Unit normals of arbitrary sign. */
  Coordinates normals;

  void
  add (const Eigen::Vector3d& position, const Eigen::Vector3d& normal)
  {
    const Eigen::Vector3f p = position.cast<float>();
    const Eigen::Vector3f n = normal.cast<float>();
    Coordinates::add (p.x(), p.y(), p.z());
    normals.add (n.x(), n.y(), n.z());
  }
};

/** \brief Draws alpha_s N of the N points, each subset equally likely (Knuth's
 * selection sampling: one pass, no repetition).
 * \param[in] rate alpha_s, clamped to 0 .. 1; alpha_s N is rounded to the nearest
 * integer
 * \return indices of the drawn points, ascending */
Indices
drawSample (std::size_t size, double rate, std::uint32_t seed);

/** \brief Returns the user's neighbor search over the finite points; if none is set,
 * the library's own, a \ref BoxTree, which has no search within a radius.
 * \param[in] input must outlive the search
 * \param[in] threads that may query the library's own search at once; 0: all */
NeighborSearch
searchOver (const DetectorInput& input, const Points& points, unsigned threads);

/** \brief Returns the weighted normal of each sample: the eigenvector of the smallest
 * eigenvalue of M_i = sum_j exp (-|q_ij - p_i|^2 / 2 sigma^2) (q_ij - p_i)(q_ij -
 * p_i)^T / |q_ij - p_i|^2 over the k nearest neighbors (paper, equation of section
 * III-A). Neighbors at distance 0 are skipped.
 * \param[in] sigma of the weight [m]; not given: the distance to the farthest neighbor
 * \return position and normal of each sample, in order. A sample without two
 * neighbors at other positions, or with all neighbors on one line through it, has no
 * normal and is left out */
OrientedSamples
orientSamples (const CloudView& cloud,
               const Points& points,
               const Indices& sample,
               const NeighborSearch& search,
               int k,
               std::optional<double> sigma);

/** \brief Returns the eigenvector of the smallest eigenvalue of a scatter matrix.
 * \return a unit vector; zero if the second eigenvalue is at most 1e-6 of the largest,
 * as it is for points on one line */
Eigen::Vector3d
normalOfScatter (const Eigen::Matrix3d& scatter);

/** \brief Divides samples into those of horizontal, vertical and other planes, for
 * strategy 2.
 * \param[in] tolerance of angles, as in \ref orientationOf [rad]
 * \param[in] up unit vector
 * \return ascending indices of the samples of each group, in the order of Orientation
 */
std::array<Indices, 3>
groupByOrientation (const OrientedSamples& samples,
                    const Eigen::Vector3d& up,
                    double tolerance);

} // namespace pcl_ops::internal
