// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/distinct_places.h"

#include "cloud/sorted_points.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace pcl_ops::internal {

namespace {

// Adds the distinct places of the points in one cell of the space-filling curve.
// \param[in,out] cell_points indices of these points; they get sorted by coordinates
void
addPlacesOfCell (const Coordinates& points,
                 Indices& cell_points,
                 DistinctPlaces& places)
{
  const auto positionOf = [&] (std::uint32_t point) {
    return std::make_tuple (points.x[point], points.y[point], points.z[point]);
  };
  std::sort (cell_points.begin(), cell_points.end(), [&] (auto first, auto second) {
    return positionOf (first) < positionOf (second);
  });
  for (std::size_t i = 0; i < cell_points.size(); ++i) {
    const std::uint32_t point = cell_points[i];
    if (i == 0 || positionOf (point) != positionOf (cell_points[i - 1]))
      places.add (points.x[point], points.y[point], points.z[point]);
    places.of_input[point] = static_cast<std::uint32_t> (places.size() - 1);
  }
}

// Returns the edge of the cells of the curve [m]: so large that no coordinate is
// farther from zero than key_limit / 2 cells. It is 1 if that edge is too small for
// single precision: then no coordinate is farther from zero than 2e-33, and points are
// told apart in any cell.
double
edgeOfCells (const Coordinates& points)
{
  // Half of what a key can hold, chosen by hand. Only the order of the places depends
  // on it.
  constexpr double max_cells_from_zero = key_limit / 2;
  float largest = 0.0F;
  for (const std::vector<float>* axis : {&points.x, &points.y, &points.z})
    for (const float coordinate : *axis)
      largest = std::max (largest, std::abs (coordinate));
  const double edge = largest / max_cells_from_zero;
  return std::isnormal (static_cast<float> (edge)) ? edge : 1.0;
}

} // namespace

DistinctPlaces
distinctPlaces (const Coordinates& points, unsigned threads)
{
  const PointRuns runs = sortedRuns (points, edgeOfCells (points), threads);
  DistinctPlaces places;
  places.of_input.resize (points.size());
  for (std::vector<float>* axis : {&places.x, &places.y, &places.z})
    axis->reserve (points.size());
  Indices cell_points;
  for (std::size_t run = 0; run < runs.size();) {
    const MortonCode code_of_cell = runs[run].code();
    cell_points.clear();
    for (; run < runs.size() && runs[run].code() == code_of_cell; ++run)
      for (std::uint32_t i = runs[run].first(); i < runs[run].end(); ++i)
        cell_points.push_back (i);
    addPlacesOfCell (points, cell_points, places);
  }
  return places;
}

} // namespace pcl_ops::internal
