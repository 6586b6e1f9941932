// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "leaves/curve_points.h"

#include "voxels/sorted_points.h"

#include <algorithm>
#include <tuple>

namespace pcl_ops::internal {

namespace {

// Adds the points of one finest cell, each place once.
void
addCell (const Coordinates& positions,
         MortonCode code,
         Indices& of_cell,
         CurvePoints& points)
{
  const auto place = [&] (std::uint32_t i) {
    return std::make_tuple (positions.x[i], positions.y[i], positions.z[i]);
  };
  if (of_cell.size() > 1)
    std::sort (of_cell.begin(), of_cell.end(), [&] (auto first, auto second) {
      return place (first) < place (second);
    });
  for (std::size_t k = 0; k < of_cell.size(); ++k) {
    const std::uint32_t i = of_cell[k];
    if (k == 0 || place (i) != place (of_cell[k - 1])) {
      points.add (positions.x[i], positions.y[i], positions.z[i]);
      points.code.push_back (code);
    }
    points.of_input[i] = static_cast<std::uint32_t> (points.size() - 1);
  }
}

} // namespace

CurvePoints
sortAlongCurve (const Coordinates& positions, double cell, unsigned threads)
{
  const PointRuns runs = sortedRuns (positions, cell, threads);
  CurvePoints points;
  points.cell = cell;
  points.of_input.resize (positions.size());
  for (std::vector<float>* axis : {&points.x, &points.y, &points.z})
    axis->reserve (positions.size());
  points.code.reserve (positions.size());
  Indices of_cell;
  for (std::size_t r = 0; r < runs.size();) {
    const MortonCode code = runs[r].code();
    of_cell.clear();
    for (; r < runs.size() && runs[r].code() == code; ++r)
      for (std::uint32_t i = runs[r].first(); i < runs[r].end(); ++i)
        of_cell.push_back (i);
    addCell (positions, code, of_cell, points);
  }
  return points;
}

std::uint32_t
endOfCell (const std::vector<MortonCode>& codes,
           std::uint32_t begin,
           std::uint32_t end,
           int level)
{
  const int shift = 3 * level;
  const MortonCode own = codes[begin] >> shift;
  // Cells are mostly small: steps that double, then halves of the last one.
  std::uint32_t inside = begin;
  std::uint32_t step = 1;
  while (inside + step < end && codes[inside + step] >> shift == own) {
    inside += step;
    step *= 2;
  }
  std::uint32_t outside = std::min (inside + step, end);
  while (outside - inside > 1) {
    const std::uint32_t middle = inside + (outside - inside) / 2;
    if (codes[middle] >> shift == own)
      inside = middle;
    else
      outside = middle;
  }
  return outside;
}

Labels
alongCurve (const CurvePoints& points, const Labels& labels)
{
  Labels along (points.size(), no_plane);
  for (std::size_t i = 0; i < labels.size(); ++i)
    along[points.of_input[i]] = labels[i];
  return along;
}

} // namespace pcl_ops::internal
