// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cell_units.h"
#include <pcl_ops/cell_planes.h>
#include <pcl_ops/parallel.h>

#include <algorithm>
#include <cmath>

namespace pcl_ops {

namespace {

/** \brief A plane a point of a cell may be on. */
struct Candidate {
  Eigen::Vector3f normal;
  float offset;
  /** \brief Largest distance of a point [m]. */
  float band;
  std::int32_t plane;
};

/** \brief The candidates of all cells, one list after the other. */
struct CandidateLists {
  std::vector<Candidate> candidates;
  /** \brief Where each cell's list starts; one more than there are cells. */
  std::vector<std::uint32_t> begin;
};

struct NearbyNoise {
  std::int32_t plane;
  double noise;
  double cells;
};

// Planes with support around a cell, and their mean noise there.
void
nearbyPlanes (const CellGrid& grid,
              const CellPlanes& planes,
              std::size_t cell,
              std::vector<NearbyNoise>& nearby)
{
  nearby.clear();
  for (const std::int32_t neighbour : grid.neighbours[cell]) {
    if (neighbour < 0)
      continue;
    const std::int32_t plane =
        planes.plane_of_cell[static_cast<std::size_t> (neighbour)];
    if (plane == no_plane)
      continue;
    auto found =
        std::find_if (nearby.begin(), nearby.end(), [plane] (const NearbyNoise& n) {
          return n.plane == plane;
        });
    if (found == nearby.end())
      found = nearby.insert (nearby.end(), {plane, 0.0, 0.0});
    found->noise += planes.noise[static_cast<std::size_t> (neighbour)];
    found->cells += 1.0;
  }
}

CandidateLists
candidatesOfCells (const CellGrid& grid,
                   const CellPlanes& planes,
                   const BoundedAssignmentParameters& parameters)
{
  const double limit = distanceLimit (grid, parameters.distance_threshold);
  CandidateLists lists;
  std::vector<NearbyNoise> nearby;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    lists.begin.push_back (static_cast<std::uint32_t> (lists.candidates.size()));
    nearbyPlanes (grid, planes, i, nearby);
    for (const NearbyNoise& n : nearby) {
      const Plane& plane = planes.planes[static_cast<std::size_t> (n.plane)];
      const double band = std::clamp (parameters.noise_factor * n.noise / n.cells,
                                      smallestBand (grid, limit),
                                      limit);
      lists.candidates.push_back ({plane.normal.cast<float>(),
                                   static_cast<float> (plane.offset),
                                   static_cast<float> (band),
                                   n.plane});
    }
  }
  lists.begin.push_back (static_cast<std::uint32_t> (lists.candidates.size()));
  return lists;
}

std::int32_t
nearestCandidate (const Coordinates& positions,
                  std::size_t point,
                  const Candidate* begin,
                  const Candidate* end)
{
  std::int32_t nearest = no_plane;
  float best = 1.0f;
  for (const Candidate* c = begin; c != end; ++c) {
    const float distance = std::abs (c->normal.x() * positions.x[point] +
                                     c->normal.y() * positions.y[point] +
                                     c->normal.z() * positions.z[point] + c->offset);
    const float relative = distance / c->band;
    nearest = relative < best ? c->plane : nearest;
    best = std::min (best, relative);
  }
  return nearest;
}

} // namespace

Labels
assignToBoundedPlanes (const Coordinates& positions,
                       const GriddedPoints& gridded,
                       const CellPlanes& planes,
                       const BoundedAssignmentParameters& parameters,
                       unsigned threads)
{
  constexpr std::size_t points_per_piece = 16384;
  const CandidateLists lists = candidatesOfCells (gridded.grid, planes, parameters);
  const Candidate* const all = lists.candidates.data();
  Labels labels (positions.size());
  parallelFor (threads,
               positions.size(),
               points_per_piece,
               [&] (std::size_t begin, std::size_t end) {
                 for (std::size_t i = begin; i < end; ++i) {
                   const std::uint32_t cell = gridded.cell_of_point[i];
                   labels[i] = nearestCandidate (positions,
                                                 i,
                                                 all + lists.begin[cell],
                                                 all + lists.begin[cell + 1]);
                 }
               });
  return labels;
}

} // namespace pcl_ops
