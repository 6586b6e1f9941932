// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "leaves/curve_points.h"

#include <array>
#include <vector>

namespace pcl_ops::internal {

/** \brief The steps of quantized coordinates, as those of a depth camera: nearly all
 * points share the values of an axis with others. Nothing is known between two values,
 * so what seems flat to the last digit is as noisy as the steps are wide. */
class CoordinateSteps {
public:
  explicit CoordinateSteps (const CurvePoints& points);

  /** \brief The widest of the steps around a place that are narrower than an edge [m];
   * 0 where coordinates come without steps. */
  double
  at (const Eigen::Vector3d& place, double edge) const;

private:
  /** \brief Of each axis, ascending; none: it has no steps. */
  std::array<std::vector<float>, 3> values_;
};

} // namespace pcl_ops::internal
