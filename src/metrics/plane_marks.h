// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "metrics.h"

#include <vector>

namespace pcl_ops::evaluation {

/** Marks for each plane of one side. The sides are the truth and the result. */
struct Marks {
  /** \param[in] id_in_overlap &Overlap::truth or &Overlap::result */
  Marks (const PlaneIds& planes_of_side, std::uint32_t Overlap::*id_in_overlap);

  /** Returns the number of planes without any mark. */
  std::size_t
  countUnmarked () const;

  const PlaneIds& planes;
  /** The member of an overlap that has the id of the plane of this side. */
  std::uint32_t Overlap::*id;
  /** For each plane whether it is matched with a plane of the other side. */
  std::vector<bool> is_matched;
  /** For each plane whether several planes of the other side cover it: a true plane is
   * over-segmented then, a found plane under-segmented. */
  std::vector<bool> is_split;
  /** For each plane whether it is one of those that cover a split plane of the other
   * side. */
  std::vector<bool> is_part;
};

/** The marks of both sides, and the sum of the intersection over union (IoU) of all
 * matches. */
struct Matching {
  Marks truth;
  Marks result;
  double iou_sum = 0.0;
};

/** Matches planes one to one, the largest IoU first, and marks matches, splits and
 * parts. A plane is split if at least two planes of the other side lie on it and
 * together cover it. A plane lies on another one if at least the share \p threshold of
 * its own points is there. A plane is covered if at least this share of its points is
 * on planes that lie on it.
 * \param[in] confusion must outlive the result
 * \param[in] threshold also the least IoU of a match */
Matching
matchingAt (const Confusion& confusion, double threshold);

/** Returns the number of planes with a mark. */
std::size_t
countMarked (const std::vector<bool>& marks);

} // namespace pcl_ops::evaluation
