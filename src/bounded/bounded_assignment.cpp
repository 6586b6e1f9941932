// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bounded/bounded_assignment.h"

#include "bounded/noise_floors.h"
#include "geometry/float_plane.h"
#include "voxels/voxel_traversal.h"

#include <algorithm>

namespace pcl_ops::internal {

namespace {

constexpr std::size_t points_per_piece = 32768;

/** \brief A plane as its points see it. */
struct Candidate {
  FloatPlane surface;
  /** \brief Largest distance of a point [m]. */
  float band;
};

/** \brief The planes around each voxel, one list after the other. */
struct CandidateLists {
  Labels planes;
  /** \brief Where each voxel's list starts; one more than there are voxels. */
  Indices begin;
};

CandidateLists
planesAround (const VoxelGrid& grid,
              const BoundedPlanes& planes,
              const std::vector<char>& is_left_out)
{
  CandidateLists lists;
  lists.begin.reserve (grid.size() + 1);
  for (std::size_t i = 0; i < grid.size(); ++i) {
    lists.begin.push_back (static_cast<std::uint32_t> (lists.planes.size()));
    if (!is_left_out.empty() && is_left_out[i] != 0)
      continue;
    for (const std::uint32_t neighbour : grid.neighbours[i]) {
      const std::int32_t plane = planes.plane_of_voxel[neighbour];
      const auto own = lists.planes.begin() + lists.begin.back();
      if (plane != no_plane &&
          std::find (own, lists.planes.end(), plane) == lists.planes.end())
        lists.planes.push_back (plane);
    }
  }
  lists.begin.push_back (static_cast<std::uint32_t> (lists.planes.size()));
  return lists;
}

// The plane of a voxel with but one candidate whose points lie so well within the band
// that none needs to be looked at; else no_plane.
Labels
planesOfAll (const VoxelGrid& grid,
             const BoundedPlanes& planes,
             const std::vector<Candidate>& candidates,
             const CandidateLists& lists)
{
  constexpr double share_of_the_band = 0.5;
  Labels planes_of_all (grid.size(), no_plane);
  for (std::size_t i = 0; i < grid.size(); ++i) {
    if (lists.begin[i + 1] - lists.begin[i] != 1)
      continue;
    const auto plane = static_cast<std::size_t> (lists.planes[lists.begin[i]]);
    const double limit = share_of_the_band * candidates[plane].band;
    if (meanSquaredDistance (grid.moments[i], planes.planes[plane]) < limit * limit)
      planes_of_all[i] = static_cast<std::int32_t> (plane);
  }
  return planes_of_all;
}

// Points, the planes each may be on, and where the labels go.
struct Assignment {
  const Coordinates& points;
  const std::vector<std::uint32_t>& voxel_of_point;
  const std::vector<Candidate>& candidates;
  const CandidateLists& lists;
  const Labels& planes_of_all;
  Labels& labels;

  std::int32_t
  nearestCandidate (std::size_t point, std::uint32_t voxel) const
  {
    std::int32_t nearest = no_plane;
    float best = 1.0f;
    for (std::uint32_t c = lists.begin[voxel]; c < lists.begin[voxel + 1]; ++c) {
      const std::int32_t plane = lists.planes[c];
      const Candidate& candidate = candidates[static_cast<std::size_t> (plane)];
      const float relative = candidate.surface.distance (
                                 points.x[point], points.y[point], points.z[point]) /
                             candidate.band;
      nearest = relative < best ? plane : nearest;
      best = std::min (best, relative);
    }
    return nearest;
  }

  /** \brief Labels a piece of the points.
   * \return the moments of those looked at one by one */
  std::vector<Moments>
  assign (std::size_t begin, std::size_t end) const
  {
    std::vector<Moments> moments (candidates.size());
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint32_t voxel = voxel_of_point[i];
      labels[i] = planes_of_all[voxel];
      if (labels[i] != no_plane)
        continue;
      labels[i] = nearestCandidate (i, voxel);
      if (labels[i] != no_plane)
        moments[static_cast<std::size_t> (labels[i])].add (
            points.x[i], points.y[i], points.z[i]);
    }
    return moments;
  }
};

std::vector<Candidate>
candidatesOf (const BoundedPlanes& planes,
              double smallest_band,
              double largest_band,
              double noise_factor)
{
  std::vector<Candidate> candidates;
  for (std::size_t p = 0; p < planes.size(); ++p)
    candidates.push_back (
        {FloatPlane (planes.planes[p]),
         static_cast<float> (std::clamp (
             noise_factor * planes.noise[p], smallest_band, largest_band))});
  return candidates;
}

} // namespace

AssignedPoints
assignToBoundedPlanes (const Coordinates& points,
                       const VoxelizedPoints& voxelized,
                       const BoundedPlanes& planes,
                       std::optional<double> distance_threshold,
                       double noise_factor,
                       unsigned threads,
                       const std::vector<char>& is_left_out)
{
  const VoxelGrid& grid = voxelized.grid;
  const double limit = distanceLimit (grid, distance_threshold);
  const std::vector<Candidate> candidates =
      candidatesOf (planes, smallestBand (grid, limit), limit, noise_factor);
  const CandidateLists lists = planesAround (grid, planes, is_left_out);
  // A threshold that was asked for is promised to every point.
  const Labels planes_of_all = distance_threshold
                                   ? Labels (grid.size(), no_plane)
                                   : planesOfAll (grid, planes, candidates, lists);
  AssignedPoints assigned;
  assigned.labels.resize (points.size());
  const Assignment assignment{points,
                              voxelized.voxel_of_point,
                              candidates,
                              lists,
                              planes_of_all,
                              assigned.labels};
  const auto partial = parallelPieces (
      threads, points.size(), points_per_piece, [&] (auto begin, auto end) {
        return assignment.assign (begin, end);
      });
  assigned.moments.resize (planes.size());
  for (std::size_t i = 0; i < grid.size(); ++i)
    if (planes_of_all[i] != no_plane)
      assigned.moments[static_cast<std::size_t> (planes_of_all[i])].addAligned (
          grid.moments[i]);
  for (const std::vector<Moments>& piece : partial)
    for (std::size_t p = 0; p < piece.size(); ++p)
      assigned.moments[p].addAligned (piece[p]);
  return assigned;
}

} // namespace pcl_ops::internal
