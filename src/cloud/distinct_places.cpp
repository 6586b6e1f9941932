// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/distinct_places.h"

#include "cloud/sorted_points.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace pcl_ops::internal {

namespace {

// Adds the distinct positions of the points in one cell of the curve.
void
addCell (const Coordinates& positions, Indices& of_cell, DistinctPlaces& places)
{
  const auto place = [&] (std::uint32_t i) {
    return std::make_tuple (positions.x[i], positions.y[i], positions.z[i]);
  };
  std::sort (of_cell.begin(), of_cell.end(), [&] (auto first, auto second) {
    return place (first) < place (second);
  });
  for (std::size_t k = 0; k < of_cell.size(); ++k) {
    const std::uint32_t i = of_cell[k];
    if (k == 0 || place (i) != place (of_cell[k - 1]))
      places.add (positions.x[i], positions.y[i], positions.z[i]);
    places.of_input[i] = static_cast<std::uint32_t> (places.size() - 1);
  }
}

// Edge of the cells of the Morton order at which no key is clamped; 1 if the edge or
// its inverse is out of range.
double
cellOf (const Coordinates& positions)
{
  constexpr double cells_from_zero = 1 << 17;
  float reach = 0.0F;
  for (const std::vector<float>* axis : {&positions.x, &positions.y, &positions.z})
    for (const float coordinate : *axis)
      reach = std::max (reach, std::abs (coordinate));
  const double cell = reach / cells_from_zero;
  return std::isnormal (static_cast<float> (cell)) &&
                 std::isnormal (static_cast<float> (1.0 / cell))
             ? cell
             : 1.0;
}

} // namespace

DistinctPlaces
distinctPlaces (const Coordinates& positions, unsigned threads)
{
  const PointRuns runs = sortedRuns (positions, cellOf (positions), threads);
  DistinctPlaces places;
  places.of_input.resize (positions.size());
  for (std::vector<float>* axis : {&places.x, &places.y, &places.z})
    axis->reserve (positions.size());
  Indices of_cell;
  for (std::size_t r = 0; r < runs.size();) {
    const MortonCode code = runs[r].code();
    of_cell.clear();
    for (; r < runs.size() && runs[r].code() == code; ++r)
      for (std::uint32_t i = runs[r].first(); i < runs[r].end(); ++i)
        of_cell.push_back (i);
    addCell (positions, of_cell, places);
  }
  return places;
}

} // namespace pcl_ops::internal
