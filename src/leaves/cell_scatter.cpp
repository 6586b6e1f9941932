// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "leaves/cell_scatter.h"

#include "geometry/principal_axes.h"
#include <pcl_ops/plane.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl_ops::internal {

namespace {

// Cells of fewer points are added up as they are; a plane needs a few more than three.
constexpr std::uint32_t points_of_a_sum = 6;
constexpr double min_points_of_scatter = 8.0;

Eigen::Matrix3d
outerProduct (const Eigen::Vector3d& vector)
{
  return vector * vector.transpose();
}

/** \brief Walks up the octree, and looks at cells many at a time. */
class ScatterOfCells {
public:
  explicit ScatterOfCells (const CurvePoints& points) : points_ (points) {}

  std::vector<CellScatter>
  ofAll ()
  {
    if (points_.size() > 0)
      momentsOfCell (0, static_cast<std::uint32_t> (points_.size()), top_level);
    measure();
    return std::move (cells_);
  }

private:
  Moments
  momentsOfCell (std::uint32_t begin, std::uint32_t end, int level)
  {
    Moments moments;
    if (end - begin <= points_of_a_sum || level == 0) {
      for (std::uint32_t i = begin; i < end; ++i)
        moments.add (points_.x[i], points_.y[i], points_.z[i]);
      return moments;
    }
    std::array<Moments, 8> eighths;
    std::size_t number = 0;
    for (std::uint32_t i = begin; i < end; ++number) {
      const std::uint32_t next = endOfCell (points_.code, i, end, level - 1);
      eighths[number] = momentsOfCell (i, next, level - 1);
      moments.addAligned (eighths[number]);
      i = next;
    }
    // A cell of a single occupied eighth is no wider than that.
    if (moments.count >= min_points_of_scatter && number > 1)
      add (begin, level, moments, eighths, number);
    return moments;
  }

  void
  add (std::uint32_t begin,
       int level,
       const Moments& moments,
       const std::array<Moments, 8>& eighths,
       std::size_t number)
  {
    const Eigen::Vector3d center = moments.centroid();
    Eigen::Matrix3d between = Eigen::Matrix3d::Zero();
    for (std::size_t k = 0; k < number; ++k)
      between += eighths[k].count / moments.count *
                 outerProduct (eighths[k].centroid() - center);
    CellScatter cell;
    cell.begin = begin;
    cell.count = static_cast<std::uint32_t> (moments.count);
    cell.level = level;
    cells_.push_back (cell);
    covariances_.push_back (moments.covariance());
    of_centers_.push_back (between);
    eighths_.push_back (static_cast<double> (number));
    constexpr std::size_t at_once = 512;
    if (covariances_.size() == at_once)
      measure();
  }

  // Measures the cells that wait for it.
  void
  measure ()
  {
    axes_.resize (covariances_.size());
    principalAxes (covariances_.data(), covariances_.size(), axes_.data());
    const std::size_t first = cells_.size() - covariances_.size();
    for (std::size_t k = 0; k < covariances_.size(); ++k)
      measure (axes_[k], of_centers_[k], eighths_[k], cells_[first + k]);
    covariances_.clear();
    of_centers_.clear();
    eighths_.clear();
  }

  void
  measure (const PrincipalAxes& axes,
           const Eigen::Matrix3d& of_centers,
           double eighths,
           CellScatter& cell) const
  {
    // Of a square that is evenly covered the variance along an edge is edge^2 / 12.
    constexpr double min_squared_width = 0.2;
    const double edge = std::ldexp (points_.cell, cell.level);
    cell.is_wide = !axes.normal.isZero() &&
                   12.0 * axes.values[1] > min_squared_width * edge * edge;
    const double count = cell.count;
    cell.noise =
        static_cast<float> (std::sqrt (axes.values[0] * count / (count - 3.0)));
    const double uneven = axes.normal.dot (of_centers * axes.normal);
    // sigma^2 / n of the mean of n points.
    const double of_means = std::max (0.0, axes.values[0] - uneven) * eighths / count;
    cell.unevenness =
        static_cast<float> (std::sqrt (std::max (0.0, uneven - of_means)));
  }

  const CurvePoints& points_;
  std::vector<CellScatter> cells_;
  std::vector<Eigen::Matrix3d> covariances_, of_centers_;
  std::vector<double> eighths_;
  std::vector<PrincipalAxes> axes_;
};

} // namespace

std::vector<CellScatter>
scatterOfCells (const CurvePoints& points)
{
  return ScatterOfCells (points).ofAll();
}

double
densityOf (double count, int level)
{
  return std::log2 (count) - 2.0 * level;
}

} // namespace pcl_ops::internal
