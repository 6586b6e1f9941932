// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cell_samples.h"
#include "cell_support.h"
#include "cell_units.h"
#include <pcl_ops/cell_planes.h>
#include <pcl_ops/plane_extraction.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl_ops {

namespace {

/** \brief Cells on a plane with their moments. */
struct CellSupport {
  Positions cells;
  Moments moments;
};

/** \brief Gives one plane after the other, the largest first, each among the candidates
 * that the ones before left. */
class LargestCellPlane {
public:
  LargestCellPlane (const CellGrid& grid,
                    const std::vector<std::optional<CellNormal>>& normals,
                    const Positions& candidates,
                    const CellRansacParameters& parameters,
                    RandomGenerator& generator)
  : grid_ (grid)
  , normals_ (normals)
  , parameters_ (parameters)
  , generator_ (generator)
  , limit_ (distanceLimit (grid, parameters.inlier.distance_threshold))
  , is_open_ (grid.size(), 1)
  , mark_ (grid.size(), 0)
  {
    for (const std::uint32_t cell : candidates)
      samples_.add (cell, grid.moments[cell], *normals[cell], band (*normals[cell]));
  }

  std::optional<ExtractedPlane>
  next ()
  {
    while (true) {
      const std::optional<CellSupport> support = supportOfLargest();
      if (!support)
        return std::nullopt;
      Positions parts = largeParts (support->cells);
      const std::optional<PlaneFit> fit = fitPlane (momentsOf (parts));
      if (fit && !isCurved (parts, fit->plane)) {
        close (parts);
        return ExtractedPlane{fit->plane, std::move (parts)};
      }
      close (support->cells);
    }
  }

private:
  // Cells on a plane found or rejected are looked at no more.
  void
  close (const Positions& cells)
  {
    for (const std::uint32_t cell : cells)
      is_open_[cell] = 0;
    keepOnly (is_open_, samples_);
  }

  double
  band (const CellNormal& normal) const
  {
    return std::clamp (parameters_.inlier.noise_factor * normal.noise,
                       smallestBand (grid_, limit_),
                       limit_);
  }

  SinglePlane
  single (const Plane& plane) const
  {
    return {static_cast<float> (plane.normal.x()),
            static_cast<float> (plane.normal.y()),
            static_cast<float> (plane.normal.z()),
            static_cast<float> (plane.offset),
            static_cast<float> (std::cos (parameters_.inlier.angle_threshold))};
  }

  std::optional<CellSupport>
  supportOfLargest ()
  {
    if (samples_.size() < parameters_.min_inliers)
      return std::nullopt;
    const auto number = static_cast<double> (samples_.size());
    const auto least = static_cast<std::int32_t> (parameters_.min_inliers);
    std::size_t n_iter =
        requiredDraws (parameters_.probability,
                       static_cast<double> (parameters_.min_inliers) / number);
    const Plane* best = nullptr;
    Support best_support;
    for (std::size_t iter = 0; iter < n_iter; ++iter) {
      const std::uint32_t drawn = samples_.cells[drawBelow (
          generator_, static_cast<std::uint32_t> (samples_.size()))];
      const Plane& hypothesis = normals_[drawn]->plane;
      const Support support = supportOf (samples_, single (hypothesis));
      if (support.weight <= best_support.weight || support.cells < least)
        continue;
      best = &hypothesis;
      best_support = support;
      n_iter = requiredDraws (parameters_.probability, support.cells / number);
    }
    return best ? std::optional<CellSupport> (grow (*best)) : std::nullopt;
  }

  // Local optimisation: refit and select again while the support grows.
  CellSupport
  grow (const Plane& hypothesis) const
  {
    CellSupport support = select (hypothesis);
    while (const std::optional<PlaneFit> fit = fitPlane (support.moments)) {
      CellSupport selected = select (fit->plane);
      if (selected.moments.count <= support.moments.count)
        break;
      support = std::move (selected);
    }
    return support;
  }

  CellSupport
  select (const Plane& plane) const
  {
    CellSupport selected{cellsOn (samples_, single (plane)), Moments()};
    selected.moments = momentsOf (selected.cells);
    return selected;
  }

  Moments
  momentsOf (const Positions& cells) const
  {
    Moments moments;
    for (const std::uint32_t cell : cells)
      moments.addAligned (grid_.moments[cell]);
    return moments;
  }

  // Whether the cells' normals spread more about the plane's than noise explains, which
  // turns the normal of a thick neighbourhood by about its thickness [rad].
  bool
  isCurved (const Positions& cells, const Plane& plane) const
  {
    double squared_sines = 0.0;
    double thickness = 0.0;
    for (const std::uint32_t cell : cells) {
      const double cosine = plane.normal.dot (normals_[cell]->plane.normal);
      squared_sines += 1.0 - cosine * cosine;
      thickness += normals_[cell]->thickness;
    }
    const auto number = static_cast<double> (cells.size());
    return std::sqrt (squared_sines / number) >
           parameters_.inlier.largest_normal_spread +
               parameters_.inlier.spread_of_thickness * thickness / number;
  }

  // The connected parts of a support with theta_N cells or more.
  Positions
  largeParts (const Positions& support)
  {
    for (const std::uint32_t cell : support)
      mark_[cell] = 1;
    Positions large;
    for (const std::uint32_t cell : support) {
      const Positions part = connectedCells (grid_, cell, [this] (std::uint32_t other) {
        return std::exchange (mark_[other], 0) != 0;
      });
      if (part.size() >= parameters_.min_inliers)
        large.insert (large.end(), part.begin(), part.end());
    }
    if (large.size() == support.size())
      return support;
    std::sort (large.begin(), large.end());
    return large;
  }

  const CellGrid& grid_;
  const std::vector<std::optional<CellNormal>>& normals_;
  const CellRansacParameters& parameters_;
  RandomGenerator& generator_;
  double limit_;
  CellSamples samples_;
  std::vector<char> is_open_;
  std::vector<char> mark_;
};

} // namespace

void
extractCellPlanes (const CellGrid& grid,
                   const std::vector<std::optional<CellNormal>>& normals,
                   const CellRansacParameters& parameters,
                   RandomGenerator& generator,
                   CellPlanes& planes)
{
  planes.plane_of_cell.resize (grid.size(), no_plane);
  planes.noise.resize (grid.size(), 0.0);
  Positions candidates;
  for (std::size_t i = 0; i < grid.size(); ++i)
    if (planes.plane_of_cell[i] == no_plane && normals[i] &&
        normals[i]->thickness < parameters.inlier.largest_thickness)
      candidates.push_back (static_cast<std::uint32_t> (i));
  LargestCellPlane largest (grid, normals, candidates, parameters, generator);
  while (const std::optional<ExtractedPlane> plane = largest.next()) {
    for (const std::uint32_t cell : plane->inliers) {
      planes.plane_of_cell[cell] = static_cast<std::int32_t> (planes.planes.size());
      planes.noise[cell] = std::max (normals[cell]->noise, smallestNoise (grid));
    }
    planes.planes.push_back (plane->plane);
  }
}

} // namespace pcl_ops
