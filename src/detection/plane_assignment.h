// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/plane.h>
#include <pcl_ops/points.h>

#include <cstdint>
#include <vector>

namespace pcl_ops {

/** \brief The plane of each point: a position in the list of planes, or \ref no_plane.
 */
using Labels = std::vector<std::int32_t>;

constexpr std::int32_t no_plane = -1;

/** \brief Which of the planes within the threshold gets a point. */
enum class AssignmentRule {
  /** \brief The nearest; of two equally near ones the first. */
  Nearest,
  /** \brief The first of the list (3D-KHT). */
  First
};

/** \brief Assigns every point to a plane.
 * \param[in] positions the points
 * \param[in] planes the planes, in the frame of the points
 * \param[in] distance_threshold theta_h: largest distance of a point to its plane [m]
 * \param[in] rule which plane gets a point that several could have
 * \param[in] threads number of threads; 0: all. The result does not depend on it
 * \return one label a point */
Labels
assignPoints (const Coordinates& positions,
              const std::vector<Plane>& planes,
              double distance_threshold,
              AssignmentRule rule,
              unsigned threads);

/** \brief Moments of the points of each label, about the zero of their frame.
 * \param[in] positions the points
 * \param[in] labels one per point; labels outside 0 .. number - 1 are left out
 * \param[in] number how many planes there are
 * \param[in] threads number of threads; 0: all. The result does not depend on it */
std::vector<Moments>
momentsOfLabels (const Coordinates& positions,
                 const Labels& labels,
                 std::size_t number,
                 unsigned threads);

} // namespace pcl_ops
