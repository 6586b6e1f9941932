// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "geometry/planar_area.h"
#include <pcl_ops/plane_extent.h>

#include <cstddef>
#include <vector>

namespace pcl_ops::internal {

/** \brief A line in a plane: origin + t direction, the direction of length 1. */
struct PlanarLine {
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();
  Eigen::Vector2d direction = Eigen::Vector2d::UnitX();

  /** \brief Above 0 to the left of the line [m]. */
  double
  distance (const Eigen::Vector2d& point) const
  {
    return cross (direction, point - origin);
  }
};

/** \brief Points in a plane, put into square cells of some points each: those beside a
 * line are found without a look at all others. */
class PointRaster {
public:
  /** \param[in] points those that are not finite are left out */
  explicit PointRaster (PlanarPoints points);

  /** \brief Where along a line the points beside it are, by their t; in no order. */
  std::vector<double>
  placesBeside (const PlanarLine& line, double reach) const;

  /** \brief Number of finite points. */
  std::size_t
  size () const
  {
    return points_.size();
  }

  /** \brief A circle around all points. */
  Eigen::Vector2d
  center () const
  {
    return low_ + 0.5 * size_;
  }
  double
  radius () const
  {
    return 0.5 * size_.norm();
  }

private:
  /** \brief From one to another, the last not among them. */
  struct Run {
    std::size_t begin, end;
  };

  std::size_t
  cellOf (double offset, std::size_t cells) const;
  Run
  cellsBeside (const PlanarLine& line, double reach, std::size_t row) const;

  Eigen::Vector2d low_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d size_ = Eigen::Vector2d::Zero();
  double cell_ = 1.0;
  double cells_per_meter_ = 1.0;
  std::size_t columns_ = 1, rows_ = 1;
  /** \brief Row after row. */
  PlanarPoints points_;
  /** \brief Where the points of each cell begin; one more than there are cells. */
  std::vector<std::size_t> begins_;
};

} // namespace pcl_ops::internal
