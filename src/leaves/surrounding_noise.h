// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "leaves/leaf_cloud.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace pcl_ops::internal {

/** \brief The noise to expect of a plane is that of so many times the points of a leaf:
 * the steps of a quantized depth are flat, and only what holds some of them tells. */
constexpr double points_that_tell = 16.0;

/** \brief The noise of the surroundings of some leaves of a plane [m]: the median over
 * them of how far points scatter about the plane through a leaf and those of its plane
 * beside it; at least what is expected of planes of sixteen times as many points there,
 * at most 1.25 times that. It does not grow with how far the plane as a whole bends.
 * \param[in] points_around such surroundings have so many points
 * \return nothing where too few leaves tell */
std::optional<double>
surroundingNoise (const LeafCloud& cloud,
                  const Labels& plane_of_leaf,
                  const Indices& leaves,
                  double points_around);

/** \brief For each plane the noise that is expected of so many points in the places of
 * its leaves, or of a leaf's own points if they are more [m]: the median over the
 * leaves. Nothing where the cloud does not tell. */
std::vector<std::optional<double>>
expectedNoises (const ExpectedNoise& expected,
                const std::vector<Leaf>& leaves,
                const Labels& plane_of_leaf,
                std::size_t planes,
                double points);

/** \brief \ref surroundingNoise of each plane, or \ref expectedNoises of
 * \ref points_that_tell where too few of its leaves tell. */
std::vector<std::optional<double>>
surroundingNoises (const LeafCloud& cloud,
                   const Labels& plane_of_leaf,
                   std::size_t planes,
                   double points_around,
                   unsigned threads);

} // namespace pcl_ops::internal
