// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "plane_marks.h"

#include <algorithm>

namespace pcl_ops::evaluation {

namespace {

/** Marks the split planes of one side, \p wholes, and their parts on the other side. */
void
markSplits (const Confusion& confusion, double threshold, Marks& wholes, Marks& others)
{
  const auto isEnough = [threshold] (std::size_t points, std::size_t all) {
    return double (points) >= threshold * double (all);
  };
  // For each whole how many planes of the other side lie on it, and how many of its
  // points they cover.
  std::vector<std::size_t> parts (wholes.planes.size(), 0);
  std::vector<std::size_t> covered_points (wholes.planes.size(), 0);
  std::vector<Overlap> overlaps_of_parts;
  for (const Overlap& overlap : confusion.overlaps)
    if (isEnough (overlap.points, others.planes.points[overlap.*others.id])) {
      overlaps_of_parts.push_back (overlap);
      ++parts[overlap.*wholes.id];
      covered_points[overlap.*wholes.id] += overlap.points;
    }
  for (std::size_t i = 0; i < parts.size(); ++i)
    wholes.is_split[i] =
        parts[i] > 1 && isEnough (covered_points[i], wholes.planes.points[i]);
  for (const Overlap& overlap : overlaps_of_parts)
    if (wholes.is_split[overlap.*wholes.id])
      others.is_part[overlap.*others.id] = true;
}

} // namespace

Marks::Marks (const PlaneIds& planes_of_side, std::uint32_t Overlap::*id_in_overlap)
: planes (planes_of_side)
, id (id_in_overlap)
, is_matched (planes_of_side.size(), false)
, is_split (planes_of_side.size(), false)
, is_part (planes_of_side.size(), false)
{}

std::size_t
Marks::countUnmarked() const
{
  std::size_t count = 0;
  for (std::size_t i = 0; i < is_matched.size(); ++i)
    if (!is_matched[i] && !is_split[i] && !is_part[i])
      ++count;
  return count;
}

Matching
matchingAt (const Confusion& confusion, double threshold)
{
  std::vector<Overlap> candidates;
  for (const Overlap& overlap : confusion.overlaps)
    if (confusion.iou (overlap) >= threshold)
      candidates.push_back (overlap);
  std::stable_sort (
      candidates.begin(), candidates.end(), [&] (const Overlap& a, const Overlap& b) {
        return confusion.iou (a) > confusion.iou (b);
      });
  Matching matching{{confusion.truth, &Overlap::truth},
                    {confusion.result, &Overlap::result}};
  Marks& truth = matching.truth;
  Marks& result = matching.result;
  for (const Overlap& pair : candidates) {
    if (truth.is_matched[pair.truth] || result.is_matched[pair.result])
      continue;
    truth.is_matched[pair.truth] = true;
    result.is_matched[pair.result] = true;
    matching.iou_sum += confusion.iou (pair);
  }
  markSplits (confusion, threshold, truth, result);
  markSplits (confusion, threshold, result, truth);
  return matching;
}

std::size_t
countMarked (const std::vector<bool>& marks)
{
  return std::size_t (std::count (marks.begin(), marks.end(), true));
}

} // namespace pcl_ops::evaluation
