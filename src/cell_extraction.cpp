// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cell_samples.h"
#include "cell_units.h"
#include <pcl_ops/cell_planes.h>
#include <pcl_ops/plane_extraction.h>

#include <algorithm>
#include <cmath>

namespace pcl_ops {

namespace {

/** \brief The finder of the peel loop: candidates are positions of cells. */
class LargestCellPlane {
public:
  LargestCellPlane (const CellGrid& grid,
                    const std::vector<std::optional<CellNormal>>& normals,
                    const CellRansacParameters& parameters,
                    RandomGenerator& generator)
  : grid_ (grid)
  , normals_ (normals)
  , parameters_ (parameters)
  , generator_ (generator)
  , limit_ (distanceLimit (grid, parameters.inlier.distance_threshold))
  , rejected_ (grid.size(), false)
  , mark_ (grid.size(), 0)
  {}

  std::optional<ExtractedPlane>
  operator() (Positions candidates)
  {
    while (true) {
      const Positions open = withoutRejected (candidates);
      const std::optional<Positions> support = supportOfLargest (open);
      if (!support)
        return std::nullopt;
      Positions parts = largeParts (*support);
      const std::optional<PlaneFit> fit = fitPlane (momentsOf (parts));
      if (fit && !isCurved (parts, fit->plane))
        return ExtractedPlane{fit->plane, std::move (parts)};
      for (const std::uint32_t cell : *support)
        rejected_[cell] = true;
    }
  }

private:
  Positions
  withoutRejected (const Positions& candidates) const
  {
    Positions open;
    open.reserve (candidates.size());
    for (const std::uint32_t cell : candidates)
      if (!rejected_[cell])
        open.push_back (cell);
    return open;
  }

  CellSamples
  samplesOf (const Positions& cells) const
  {
    CellSamples samples;
    for (const std::uint32_t cell : cells)
      samples.add (grid_.moments[cell], *normals_[cell], band (*normals_[cell]));
    return samples;
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

  std::optional<Positions>
  supportOfLargest (const Positions& open)
  {
    if (open.size() < parameters_.min_inliers)
      return std::nullopt;
    const CellSamples samples = samplesOf (open);
    const auto number = static_cast<double> (open.size());
    const auto least = static_cast<std::int32_t> (parameters_.min_inliers);
    std::size_t n_iter =
        requiredDraws (parameters_.probability,
                       static_cast<double> (parameters_.min_inliers) / number);
    std::optional<Plane> best;
    Support best_support;
    for (std::size_t iter = 0; iter < n_iter; ++iter) {
      const std::uint32_t drawn =
          open[drawBelow (generator_, static_cast<std::uint32_t> (open.size()))];
      const Plane& hypothesis = normals_[drawn]->plane;
      const Support support = supportOf (samples, single (hypothesis));
      if (support.weight <= best_support.weight || support.cells < least)
        continue;
      best = hypothesis;
      best_support = support;
      n_iter = requiredDraws (parameters_.probability, support.cells / number);
    }
    return best ? std::optional<Positions> (grow (open, samples, *best)) : std::nullopt;
  }

  // Local optimisation: refit and select again while the support grows.
  Positions
  grow (const Positions& open,
        const CellSamples& samples,
        const Plane& hypothesis) const
  {
    Positions support = select (open, samples, hypothesis);
    double weight = momentsOf (support).count;
    while (const std::optional<PlaneFit> fit = fitPlane (momentsOf (support))) {
      Positions selected = select (open, samples, fit->plane);
      const double selected_weight = momentsOf (selected).count;
      if (selected_weight <= weight)
        break;
      support = std::move (selected);
      weight = selected_weight;
    }
    return support;
  }

  Positions
  select (const Positions& open, const CellSamples& samples, const Plane& plane) const
  {
    const SinglePlane single_plane = single (plane);
    Positions selected;
    for (std::size_t i = 0; i < open.size(); ++i)
      if (isInlier (single_plane,
                    samples.centroids.x[i],
                    samples.centroids.y[i],
                    samples.centroids.z[i],
                    samples.normals.x[i],
                    samples.normals.y[i],
                    samples.normals.z[i],
                    samples.bands[i]))
        selected.push_back (open[i]);
    return selected;
  }

  Moments
  momentsOf (const Positions& cells) const
  {
    Moments moments;
    for (const std::uint32_t cell : cells)
      moments += grid_.moments[cell];
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
      const Positions part = connectedPart (cell);
      if (part.size() >= parameters_.min_inliers)
        large.insert (large.end(), part.begin(), part.end());
    }
    std::sort (large.begin(), large.end());
    return large;
  }

  // All marked cells connected to one; unmarks them.
  Positions
  connectedPart (std::uint32_t start)
  {
    Positions part;
    const auto visit = [&] (std::uint32_t cell) {
      if (mark_[cell] == 0)
        return;
      mark_[cell] = 0;
      part.push_back (cell);
    };
    visit (start);
    for (std::size_t i = 0; i < part.size(); ++i)
      for (const std::uint32_t neighbour : grid_.neighbours[part[i]])
        visit (neighbour);
    return part;
  }

  const CellGrid& grid_;
  const std::vector<std::optional<CellNormal>>& normals_;
  const CellRansacParameters& parameters_;
  RandomGenerator& generator_;
  double limit_;
  std::vector<bool> rejected_;
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
  LargestCellPlane largest (grid, normals, parameters, generator);
  for (const ExtractedPlane& plane : extractAll (std::move (candidates), largest)) {
    for (const std::uint32_t cell : plane.inliers) {
      planes.plane_of_cell[cell] = static_cast<std::int32_t> (planes.planes.size());
      planes.noise[cell] = std::max (normals[cell]->noise, smallestNoise (grid));
    }
    planes.planes.push_back (plane.plane);
  }
}

} // namespace pcl_ops
