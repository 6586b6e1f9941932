// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/search/search.h>

#include <pcl_ops/orientation.h>
#include <pcl_ops/points.h>

#include <array>
#include <cstdint>
#include <vector>

namespace pcl_ops {

/** \brief How the normal of a sample is found (paper section III-A, M_i). */
struct NormalParameters {
  /** \brief k: neighbours of each sample. */
  int k = 30;
  /** \brief sigma of the weight [m]; 0: the distance to the farthest neighbour. */
  double sigma = 0.0;
};

/** \brief P_s with normals, in the local frame of Points. */
struct OrientedSamples : Coordinates {
  /** \brief Unit normals; their sign means nothing. */
  Coordinates normals;

  /** \brief Adds a sample. */
  void
  add (const Eigen::Vector3d& position, const Eigen::Vector3d& normal);
};

/** \brief Draws alpha_s N of the N points, each subset equally likely (Knuth's
 * selection sampling: one pass, no repetition). \param[in] size N \param[in] rate
 * alpha_s, 0 .. 1; the number drawn is rounded to the nearest \param[in] seed the same
 * seed draws the same points */
Positions
drawSample (std::size_t size, double rate, std::uint32_t seed);

/** \brief The weighted normal of each sample: the eigenvector of the smallest
 * eigenvalue of M_i = sum_j exp (-|q_ij - p_i|^2 / 2 sigma^2) (q_ij - p_i)(q_ij -
 * p_i)^T / |q_ij - p_i|^2 over the k nearest neighbours (paper, equation of section
 * III-A). Neighbours at distance 0 are skipped. \param[in] cloud the input cloud
 * \param[in] points the finite points of it
 * \param[in] sample positions in \p points
 * \param[in] search neighbour search whose input is set to \p cloud
 * \param[in] parameters k and sigma
 * \param[in] threads number of threads that may query \p search at once; 0: all
 * \return position and normal of each sample, in order; samples whose neighbours are
 * fewer than two or on one line have no normal and are left out */
template <typename PointT>
OrientedSamples
orientSamples (const pcl::PointCloud<PointT>& cloud,
               const Points& points,
               const Positions& sample,
               const pcl::search::Search<PointT>& search,
               const NormalParameters& parameters,
               unsigned threads);

/** \brief The eigenvector of the smallest eigenvalue of a scatter matrix.
 * \return a unit vector, or zero where the matrix has rank one or less */
Eigen::Vector3d
normalOfScatter (const Eigen::Matrix3d& scatter);

/** \brief Strategy 2: positions of the horizontal, vertical and other samples. */
std::array<Positions, 3>
groupByOrientation (const OrientedSamples& samples,
                    const Eigen::Vector3d& up,
                    double tolerance);

} // namespace pcl_ops

#include <pcl_ops/impl/oriented_samples.hpp>
