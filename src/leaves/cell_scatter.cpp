// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "leaves/cell_scatter.h"

#include "base/parallel.h"
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

/** \brief Points in the eighths of a cell, by the last bits of their codes. */
struct EighthsOfCell {
  std::array<double, 8> count{};
  std::array<Eigen::Vector3d, 8> sum;

  EighthsOfCell() { sum.fill (Eigen::Vector3d::Zero()); }

  void
  set (unsigned eighth, const Moments& moments)
  {
    count[eighth] = moments.count;
    sum[eighth] = moments.sum;
  }
};

/** \brief How the quarters of a cell, columns along an axis, lie about a plane. */
struct QuartersOfCell {
  double number = 0.0;
  double uneven = 0.0; // mean squared distance of their centroids, by points [m^2]

  /** \brief The columns run along the axis next to the normal: a surface between two
   * eighths would part its noise into what is above and what is below. */
  QuartersOfCell (const EighthsOfCell& eighths,
                  const Eigen::Vector3d& centroid,
                  const Eigen::Vector3d& normal)
  {
    int axis = 0;
    normal.cwiseAbs().maxCoeff (&axis);
    const unsigned above = 1U << static_cast<unsigned> (axis);
    double points = 0.0;
    for (unsigned eighth = 0; eighth < 8; ++eighth) {
      if ((eighth & above) != 0)
        continue;
      const double count = eighths.count[eighth] + eighths.count[eighth | above];
      if (count == 0.0)
        continue;
      const Eigen::Vector3d sum = eighths.sum[eighth] + eighths.sum[eighth | above];
      const double height = normal.dot (sum / count - centroid);
      uneven += count * height * height;
      points += count;
      number += 1.0;
    }
    uneven /= points;
  }
};

/** \brief A cell whose moments are known. */
struct KnownCell {
  std::uint32_t begin = 0, end = 0;
  int level = 0;
  Moments moments = {};
};

/** \brief Walks up the octree, and looks at cells many at a time. */
class ScatterOfCells {
public:
  explicit ScatterOfCells (const CurvePoints& points) : points_ (points) {}

  /** \brief Adds the cells within a cell, and itself. */
  void
  addWithin (KnownCell& cell)
  {
    cell.moments = momentsOfCell (cell.begin, cell.end, cell.level);
  }

  /** \brief Adds the cells that hold others, which are in the order of the points. */
  void
  addAbove (const std::vector<KnownCell>& cells)
  {
    known_ = cells.data();
    level_of_known_ = cells.front().level;
    momentsOfCell (0, static_cast<std::uint32_t> (points_.size()), top_level);
  }

  std::vector<CellScatter>
  taken ()
  {
    measure();
    return std::move (cells_);
  }

private:
  Moments
  momentsOfCell (std::uint32_t begin, std::uint32_t end, int level)
  {
    if (known_ != nullptr && level == level_of_known_) {
      ++known_;
      return known_[-1].moments;
    }
    Moments moments;
    if (known_ == nullptr && (end - begin <= points_of_a_sum || level == 0)) {
      for (std::uint32_t i = begin; i < end; ++i)
        moments.add (points_.x[i], points_.y[i], points_.z[i]);
      return moments;
    }
    EighthsOfCell eighths;
    int number = 0;
    for (std::uint32_t i = begin; i < end; ++number) {
      const std::uint32_t next = endOfCell (points_.code, i, end, level - 1);
      const Moments of_eighth = momentsOfCell (i, next, level - 1);
      eighths.set (points_.code[i] >> 3 * (level - 1) & 7, of_eighth);
      moments.addAligned (of_eighth);
      i = next;
    }
    // A cell of a single occupied eighth is no wider than that.
    if (moments.count >= min_points_of_scatter && number > 1)
      add (begin, level, moments, eighths);
    return moments;
  }

  void
  add (std::uint32_t begin,
       int level,
       const Moments& moments,
       const EighthsOfCell& eighths)
  {
    CellScatter cell;
    cell.begin = begin;
    cell.count = static_cast<std::uint32_t> (moments.count);
    cell.level = level;
    cells_.push_back (cell);
    centroids_.push_back (moments.centroid());
    covariances_.push_back (moments.covariance());
    eighths_.push_back (eighths);
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
      measure (axes_[k],
               QuartersOfCell (eighths_[k], centroids_[k], axes_[k].normal),
               cells_[first + k]);
    centroids_.clear();
    covariances_.clear();
    eighths_.clear();
  }

  void
  measure (const PrincipalAxes& axes,
           const QuartersOfCell& quarters,
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
    // sigma^2 / n of the mean of n points.
    const double of_means =
        std::max (0.0, axes.values[0] - quarters.uneven) * quarters.number / count;
    cell.unevenness =
        static_cast<float> (std::sqrt (std::max (0.0, quarters.uneven - of_means)));
  }

  const CurvePoints& points_;
  const KnownCell* known_ = nullptr;
  int level_of_known_ = 0;
  std::vector<CellScatter> cells_ = {};
  std::vector<Eigen::Vector3d> centroids_;
  std::vector<Eigen::Matrix3d> covariances_;
  std::vector<EighthsOfCell> eighths_;
  std::vector<PrincipalAxes> axes_;
};

} // namespace

std::vector<CellScatter>
scatterOfCells (const CurvePoints& points, unsigned threads)
{
  // Cells of this level are looked at independently: each holds some 10,000 points.
  constexpr int level_at_once = 10;
  std::vector<KnownCell> large;
  const auto end = static_cast<std::uint32_t> (points.size());
  for (std::uint32_t i = 0; i < end; i = large.back().end)
    large.push_back (
        {i, endOfCell (points.code, i, end, level_at_once), level_at_once});
  if (large.empty())
    return {};
  const auto within =
      parallelChunks (threads, large.size(), 1, [&] (std::size_t cell, std::size_t) {
        ScatterOfCells scatter (points);
        scatter.addWithin (large[cell]);
        return scatter.taken();
      });
  std::vector<CellScatter> all;
  for (const std::vector<CellScatter>& cells : within)
    all.insert (all.end(), cells.begin(), cells.end());
  ScatterOfCells above (points);
  above.addAbove (large);
  const std::vector<CellScatter> largest = above.taken();
  all.insert (all.end(), largest.begin(), largest.end());
  return all;
}

double
densityOf (double count, int level)
{
  return std::log2 (count) - 2.0 * level;
}

} // namespace pcl_ops::internal
