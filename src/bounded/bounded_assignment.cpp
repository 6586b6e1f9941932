// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bounded/bounded_assignment.h"

#include "bounded/noise_floors.h"
#include "geometry/float_plane.h"
#include "voxels/voxel_traversal.h"

#include <algorithm>
#include <cmath>

namespace pcl_ops::internal {

namespace {

constexpr std::size_t points_per_piece = 32768;

/** \brief How far from a plane its points may be. */
struct Bands {
  std::optional<double> distance_threshold;
  double noise_factor;
};

/** \brief A plane a point of a voxel may be on. */
struct Candidate {
  FloatPlane surface;
  /** \brief Largest distance of a point [m]. */
  float band;
  std::int32_t plane;
};

/** \brief The candidates of all voxels, one list after the other. */
struct CandidateLists {
  std::vector<Candidate> candidates;
  /** \brief Where each voxel's list starts; one more than there are voxels. */
  std::vector<std::uint32_t> begin;
  /** \brief The plane of a voxel all of whose points are on it; no_plane where they
   * have to be looked at one by one. */
  Labels plane_of_all;
};

struct NearbyPlane {
  std::int32_t plane;
  double noise;
  double voxels;
};

// Planes with support around a voxel, and the sum of their noise there.
void
findNearbyPlanes (const VoxelGrid& grid,
                  const BoundedPlanes& planes,
                  std::size_t voxel,
                  std::vector<NearbyPlane>& nearby)
{
  nearby.clear();
  for (const std::uint32_t neighbour : grid.neighbours[voxel]) {
    const std::int32_t plane = planes.plane_of_voxel[neighbour];
    if (plane == no_plane)
      continue;
    auto found =
        std::find_if (nearby.begin(), nearby.end(), [plane] (const NearbyPlane& n) {
          return n.plane == plane;
        });
    if (found == nearby.end())
      found = nearby.insert (nearby.end(), {plane, 0.0, 0.0});
    found->noise += planes.noise[neighbour];
    found->voxels += 1.0;
  }
}

// Whether a voxel's points lie so well within the band that none need be looked at.
bool
isWholly (const Moments& voxel, const Plane& plane, double band)
{
  constexpr double share_of_the_band = 0.5;
  const double limit = share_of_the_band * band;
  return meanSquaredDistance (voxel, plane) < limit * limit;
}

// The candidates of a range of voxels.
CandidateLists
candidatesOf (const VoxelGrid& grid,
              const BoundedPlanes& planes,
              const Bands& bands,
              const std::vector<char>& is_left_out,
              std::size_t begin,
              std::size_t end)
{
  const double limit = distanceLimit (grid, bands.distance_threshold);
  // A threshold that was asked for is promised to every point.
  const bool keeps_to_threshold = bands.distance_threshold.has_value();
  CandidateLists lists;
  std::vector<NearbyPlane> nearby;
  for (std::size_t i = begin; i < end; ++i) {
    lists.begin.push_back (static_cast<std::uint32_t> (lists.candidates.size()));
    lists.plane_of_all.push_back (no_plane);
    if (!is_left_out.empty() && is_left_out[i])
      continue;
    findNearbyPlanes (grid, planes, i, nearby);
    for (const NearbyPlane& n : nearby) {
      const Plane& plane = planes.planes[static_cast<std::size_t> (n.plane)];
      const double band = std::clamp (
          bands.noise_factor * n.noise / n.voxels, smallestBand (grid, limit), limit);
      lists.candidates.push_back (
          {FloatPlane (plane), static_cast<float> (band), n.plane});
      if (!keeps_to_threshold && nearby.size() == 1 &&
          isWholly (grid.moments[i], plane, band))
        lists.plane_of_all.back() = n.plane;
    }
  }
  return lists;
}

CandidateLists
candidatesOfVoxels (const VoxelGrid& grid,
                    const BoundedPlanes& planes,
                    const Bands& bands,
                    const std::vector<char>& is_left_out,
                    unsigned threads)
{
  CandidateLists all;
  all.begin.reserve (grid.size() + 1);
  all.plane_of_all.reserve (grid.size());
  for (const CandidateLists& piece : parallelPieces (
           threads, grid.size(), voxels_per_piece, [&] (auto begin, auto end) {
             return candidatesOf (grid, planes, bands, is_left_out, begin, end);
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
nearestCandidate (const Coordinates& points,
                  std::size_t point,
                  const Candidate* begin,
                  const Candidate* end)
{
  std::int32_t nearest = no_plane;
  float best = 1.0f;
  for (const Candidate* c = begin; c != end; ++c) {
    const float distance =
        c->surface.distance (points.x[point], points.y[point], points.z[point]);
    const float relative = distance / c->band;
    nearest = relative < best ? c->plane : nearest;
    best = std::min (best, relative);
  }
  return nearest;
}

// Labels a piece of the points; returns the moments of those looked at one by one.
std::vector<Moments>
assignPiece (const Coordinates& points,
             const std::vector<std::uint32_t>& voxel_of_point,
             const CandidateLists& lists,
             std::size_t number_of_planes,
             std::size_t begin,
             std::size_t end,
             Labels& labels)
{
  std::vector<Moments> moments (number_of_planes);
  for (std::size_t i = begin; i < end; ++i) {
    const std::uint32_t voxel = voxel_of_point[i];
    labels[i] = lists.plane_of_all[voxel];
    if (labels[i] != no_plane)
      continue;
    labels[i] = nearestCandidate (points,
                                  i,
                                  lists.candidates.data() + lists.begin[voxel],
                                  lists.candidates.data() + lists.begin[voxel + 1]);
    if (labels[i] != no_plane)
      moments[static_cast<std::size_t> (labels[i])].add (
          points.x[i], points.y[i], points.z[i]);
  }
  return moments;
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
  const CandidateLists lists = candidatesOfVoxels (
      voxelized.grid, planes, {distance_threshold, noise_factor}, is_left_out, threads);
  AssignedPoints assigned;
  assigned.labels.resize (points.size());
  const auto partial = parallelPieces (
      threads, points.size(), points_per_piece, [&] (auto begin, auto end) {
        return assignPiece (points,
                            voxelized.voxel_of_point,
                            lists,
                            planes.planes.size(),
                            begin,
                            end,
                            assigned.labels);
      });
  assigned.moments.resize (planes.planes.size());
  for (std::size_t i = 0; i < voxelized.grid.size(); ++i)
    if (lists.plane_of_all[i] != no_plane)
      assigned.moments[static_cast<std::size_t> (lists.plane_of_all[i])].addAligned (
          voxelized.grid.moments[i]);
  for (const std::vector<Moments>& piece : partial)
    for (std::size_t p = 0; p < piece.size(); ++p)
      assigned.moments[p].addAligned (piece[p]);
  return assigned;
}

} // namespace pcl_ops::internal
