// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <evaluation/labels/labels.h>

namespace pcl_ops::evaluation {

/** \brief Number of points a true plane and a found plane have in common. */
struct Overlap {
  std::uint32_t truth, result;
  std::size_t points;
};

/** \brief How two labelings of the same points meet: only pairs that do are stored. */
struct Confusion {
  PlaneIds truth, result;
  /** \brief By truth, then by result; ids as in \ref truth and \ref result. */
  std::vector<Overlap> overlaps;
  std::size_t points = 0;
  std::size_t points_on_no_plane_in_both = 0;
  /** \brief Points on no true plane. */
  std::size_t points_off_planes = 0;

  /** \brief Intersection over union of the two planes of an overlap. */
  double
  iou (const Overlap& overlap) const
  {
    const std::size_t both =
        truth.points[overlap.truth] + result.points[overlap.result] - overlap.points;
    return static_cast<double> (overlap.points) / static_cast<double> (both);
  }
};

/** \brief Counts the points of each pair of planes in one pass.
 * \param[in] truth, result labels of the same points: of equal size */
Confusion
confusionOf (const PlaneLabels& truth, const PlaneLabels& result);

/** \brief The pairing of rows with columns, each used at most once, with the largest
 * sum of benefits: the Hungarian method by shortest augmenting paths (Kuhn 1955; Jonker
 * & Volgenant 1987), O(min(rows, columns)^2 max(rows, columns)).
 * \return the column of each row, or -1 where there are fewer columns than rows and the
 * row is left over */
std::vector<std::ptrdiff_t>
maximumAssignment (const Eigen::MatrixXd& benefit);

/** \brief The points of the one-to-one assignment of planes that has most points in
 * common (the paper's Hungarian assignment, section IV).
 * \throw std::length_error for more labels than any segmentation into planes has */
std::size_t
pointsOfAssignment (const Confusion& confusion);

} // namespace pcl_ops::evaluation
