// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <evaluation/labels/labels.h>

namespace pcl_ops::evaluation {

enum class Side { Truth, Result };

/** \brief Number of points a true plane and a found plane have in common. */
struct Overlap {
  std::uint32_t truth;
  std::uint32_t result;
  std::size_t points;

  std::uint32_t
  plane (Side side) const
  {
    return side == Side::Truth ? truth : result;
  }
};

/** \brief How two labelings of the same points meet: only pairs that do are stored. */
struct Confusion {
  PlaneIds truth;
  PlaneIds result;
  /** \brief By truth, then by result; ids as in \ref truth and \ref result. */
  std::vector<Overlap> overlaps;
  std::size_t points = 0;
  std::size_t points_on_no_plane_in_both = 0;
  /** \brief Points on no true plane. */
  std::size_t points_off_planes = 0;

  const PlaneIds&
  planes (Side side) const
  {
    return side == Side::Truth ? truth : result;
  }

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

/** \brief The pairs of the one-to-one assignment of planes with the largest number of
 * common points (the paper's Hungarian assignment, section IV).
 * \throw std::length_error for more labels than any segmentation into planes has */
std::vector<Overlap>
assignPlanes (const Confusion& confusion);

} // namespace pcl_ops::evaluation
