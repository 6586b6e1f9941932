// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene.h"
#include <pcl_ops/orientation.h>

using namespace pcl_ops;

namespace {

const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();

/** \brief A normal at an angle from the up axis [rad]. */
Eigen::Vector3d
tilted (double angle)
{
  return {std::sin (angle), 0.0, std::cos (angle)};
}

} // namespace

TEST (OrientationOf, IsThatOfTheAngleFromTheUpAxis)
{
  const struct {
    Eigen::Vector3d normal, up;
    double tolerance;
    Orientation expected;
  } rows[] = {{tilted (0_deg), up, 7_deg, Orientation::Horizontal},
              {tilted (6.9_deg), up, 7_deg, Orientation::Horizontal},
              {tilted (7.1_deg), up, 7_deg, Orientation::Other},
              {tilted (45_deg), up, 7_deg, Orientation::Other},
              {tilted (82.9_deg), up, 7_deg, Orientation::Other},
              {tilted (83.1_deg), up, 7_deg, Orientation::Vertical},
              {tilted (90_deg), up, 7_deg, Orientation::Vertical},
              {up, up, 0.0, Orientation::Horizontal},
              {Eigen::Vector3d::UnitX(), up, 0.0, Orientation::Vertical},
              // Rounded to a length above 1: acos of the cosine would be NaN.
              {up * (1.0 + 1e-15), up, 7_deg, Orientation::Horizontal},
              {up, -Eigen::Vector3d::UnitY(), 7_deg, Orientation::Vertical}};
  for (const auto& row : rows)
    for (const double sign : {1.0, -1.0})
      EXPECT_EQ (orientationOf (sign * row.normal, row.up, row.tolerance), row.expected)
          << row.normal.transpose();
}
