// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/plane_matching.h>

#include <cstddef>
#include <vector>

namespace pcl_ops::evaluation {

/** \brief A plane of one result and the plane of another that is the same. */
struct MatchedPlanes {
  /** \brief Positions in the two results. */
  std::size_t first, second;
  /** \brief Between the normals, whichever way they point [degree]. */
  double angle;
  /** \brief Height of the second's middle over the first, along the first's normal [m].
   */
  double offset;
};

/** \brief What two results have in common. */
struct PlaneComparison {
  /** \brief In the order of the first. */
  std::vector<MatchedPlanes> matched;
  /** \brief Those without a partner. */
  std::vector<std::size_t> only_first, only_second;
  /** \brief The motion of the second result after which matched planes agree best: its
   * angle [degree], and how far it moves the middle of the first result [m]. */
  double angle = 0.0, shift = 0.0;
};

/** \brief Compares two lists of planes in the same frame by \ref matchPlanes. Angles
 * and offsets are those of the planes as they are. */
PlaneComparison
comparePlanes (const std::vector<PlaneSegment>& first,
               const std::vector<PlaneSegment>& second,
               const PlaneMatchingParameters& parameters);

} // namespace pcl_ops::evaluation
