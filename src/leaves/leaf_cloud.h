// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "leaves/coordinate_steps.h"
#include "leaves/expected_noise.h"
#include "leaves/leaf_division.h"
#include "leaves/leaf_neighbors.h"
#include <pcl_ops/plane.h>

#include <vector>

namespace pcl_ops::internal {

/** \brief A cloud divided into leaves, with what the stages ask of them. */
struct LeafCloud {
  const CurvePoints* points;
  const ExpectedNoise* expected;
  std::vector<Leaf> leaves;
  LeafNeighbors neighbors = {};
  /** \brief Of each leaf's points about the zero of their frame. */
  std::vector<Moments> moments = {};
  std::vector<double> edge = {};
  /** \brief \ref densityOf the points of each leaf. */
  std::vector<double> density = {};
  /** \brief The least noise a plane can have there [m]. */
  std::vector<double> min_noise = {};
  /** \brief No more than is expected there of any number of points [m]. */
  std::vector<double> lowest_expected = {};

  std::size_t
  size () const
  {
    return leaves.size();
  }

  /** \brief The noise to expect there of a plane of so many points [m]. */
  double
  expectedNoise (std::size_t leaf, double points_of_plane) const
  {
    return expected->of (density[leaf], points_of_plane);
  }
};

/** \brief Connects leaves and measures what lies in them. */
LeafCloud
measureLeaves (const CurvePoints& points,
               const ExpectedNoise& expected,
               const CoordinateSteps& steps,
               std::vector<Leaf> leaves,
               unsigned threads);

/** \brief Which leaves are on which plane: one list of planes, one label a leaf. */
struct LeafPlanes {
  std::vector<Plane> planes;
  Labels plane_of_leaf;
  /** \brief The noise of the leaf's plane there [m]. */
  std::vector<double> noise;
  /** \brief Whether a leaf is on a curved surface, which is no plane. */
  std::vector<char> is_curved;
};

/** \brief Moments of the points of each plane. */
std::vector<Moments>
momentsOfPlanes (const LeafCloud& cloud, const LeafPlanes& planes);

/** \brief Fits each plane to its leaves. */
void
refitPlanes (const LeafCloud& cloud, LeafPlanes& planes);

/** \brief The absolute cosine of the angle between two planes. */
inline double
cosineBetween (const Plane& a, const Plane& b)
{
  return std::abs (a.normal.dot (b.normal));
}

} // namespace pcl_ops::internal
