// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cell_support.h"
#include "cell_units.h"

#include <algorithm>
#include <cmath>

namespace pcl_ops {

namespace {

constexpr std::size_t points_per_piece = 32768;

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
  /** \brief The plane of a cell all of whose points are on it; no_plane where they have
   * to be looked at one by one. */
  Labels plane_of_all;
};

struct NearbyPlane {
  std::int32_t plane;
  double noise;
  double cells;
};

// Planes with support around a cell, and the sum of their noise there.
void
findNearbyPlanes (const CellGrid& grid,
                  const CellPlanes& planes,
                  std::size_t cell,
                  std::vector<NearbyPlane>& nearby)
{
  nearby.clear();
  for (const std::uint32_t neighbour : grid.neighbours[cell]) {
    const std::int32_t plane = planes.plane_of_cell[neighbour];
    if (plane == no_plane)
      continue;
    auto found =
        std::find_if (nearby.begin(), nearby.end(), [plane] (const NearbyPlane& n) {
          return n.plane == plane;
        });
    if (found == nearby.end())
      found = nearby.insert (nearby.end(), {plane, 0.0, 0.0});
    found->noise += planes.noise[neighbour];
    found->cells += 1.0;
  }
}

// Whether a cell's points lie so well within the band that none need be looked at.
bool
isWholly (const Moments& cell, const Plane& plane, double band)
{
  constexpr double share_of_the_band = 0.5;
  const double limit = share_of_the_band * band;
  return meanSquaredDistance (cell, plane) < limit * limit;
}

// The candidates of a range of cells.
CandidateLists
candidatesOf (const CellGrid& grid,
              const CellPlanes& planes,
              const BoundedAssignmentParameters& parameters,
              std::size_t begin,
              std::size_t end)
{
  const double limit = distanceLimit (grid, parameters.distance_threshold);
  // A threshold that was asked for is promised to every point.
  const bool keeps_to_threshold = parameters.distance_threshold > 0.0;
  CandidateLists lists;
  std::vector<NearbyPlane> nearby;
  for (std::size_t i = begin; i < end; ++i) {
    lists.begin.push_back (static_cast<std::uint32_t> (lists.candidates.size()));
    lists.plane_of_all.push_back (no_plane);
    findNearbyPlanes (grid, planes, i, nearby);
    for (const NearbyPlane& n : nearby) {
      const Plane& plane = planes.planes[static_cast<std::size_t> (n.plane)];
      const double band = std::clamp (parameters.noise_factor * n.noise / n.cells,
                                      smallestBand (grid, limit),
                                      limit);
      lists.candidates.push_back ({plane.normal.cast<float>(),
                                   static_cast<float> (plane.offset),
                                   static_cast<float> (band),
                                   n.plane});
      if (!keeps_to_threshold && nearby.size() == 1 &&
          isWholly (grid.moments[i], plane, band))
        lists.plane_of_all.back() = n.plane;
    }
  }
  return lists;
}

CandidateLists
candidatesOfCells (const CellGrid& grid,
                   const CellPlanes& planes,
                   const BoundedAssignmentParameters& parameters,
                   unsigned threads)
{
  CandidateLists all;
  all.begin.reserve (grid.size() + 1);
  all.plane_of_all.reserve (grid.size());
  for (const CandidateLists& piece : parallelPieces (
           threads, grid.size(), cells_per_piece, [&] (auto begin, auto end) {
             return candidatesOf (grid, planes, parameters, begin, end);
           })) {
    const auto before = static_cast<std::uint32_t> (all.candidates.size());
    for (const std::uint32_t begin : piece.begin)
      all.begin.push_back (before + begin);
    const auto append = [] (const auto& part, auto& whole) {
      whole.insert (whole.end(), part.begin(), part.end());
    };
    append (piece.candidates, all.candidates);
    append (piece.plane_of_all, all.plane_of_all);
  }
  all.begin.push_back (static_cast<std::uint32_t> (all.candidates.size()));
  return all;
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

// Labels a piece of the points; returns the moments of those looked at one by one.
std::vector<Moments>
assignPiece (const Coordinates& positions,
             const std::vector<std::uint32_t>& cell_of_point,
             const CandidateLists& lists,
             std::size_t number_of_planes,
             std::size_t begin,
             std::size_t end,
             Labels& labels)
{
  std::vector<Moments> moments (number_of_planes);
  for (std::size_t i = begin; i < end; ++i) {
    const std::uint32_t cell = cell_of_point[i];
    labels[i] = lists.plane_of_all[cell];
    if (labels[i] != no_plane)
      continue;
    labels[i] = nearestCandidate (positions,
                                  i,
                                  lists.candidates.data() + lists.begin[cell],
                                  lists.candidates.data() + lists.begin[cell + 1]);
    if (labels[i] != no_plane)
      moments[static_cast<std::size_t> (labels[i])].add (
          positions.x[i], positions.y[i], positions.z[i]);
  }
  return moments;
}

} // namespace

AssignedPoints
assignToBoundedPlanes (const Coordinates& positions,
                       const GriddedPoints& gridded,
                       const CellPlanes& planes,
                       const BoundedAssignmentParameters& parameters,
                       unsigned threads)
{
  const CandidateLists lists =
      candidatesOfCells (gridded.grid, planes, parameters, threads);
  AssignedPoints assigned;
  assigned.labels.resize (positions.size());
  const auto partial = parallelPieces (
      threads, positions.size(), points_per_piece, [&] (auto begin, auto end) {
        return assignPiece (positions,
                            gridded.cell_of_point,
                            lists,
                            planes.planes.size(),
                            begin,
                            end,
                            assigned.labels);
      });
  assigned.moments.resize (planes.planes.size());
  for (std::size_t i = 0; i < gridded.grid.size(); ++i)
    if (lists.plane_of_all[i] != no_plane)
      assigned.moments[static_cast<std::size_t> (lists.plane_of_all[i])].addAligned (
          gridded.grid.moments[i]);
  for (const std::vector<Moments>& piece : partial)
    for (std::size_t p = 0; p < piece.size(); ++p)
      assigned.moments[p].addAligned (piece[p]);
  return assigned;
}

} // namespace pcl_ops
