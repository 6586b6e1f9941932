// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "leaves/coordinate_steps.h"

#include <algorithm>
#include <cmath>

namespace pcl_ops::internal {

namespace {

// Values that several points share, if nearly all points are on one.
std::vector<float>
sharedValues (const std::vector<float>& coordinates)
{
  constexpr std::size_t looked_at = 6000;
  constexpr std::size_t min_points_of_a_value = 5;
  constexpr std::size_t min_values = 20;
  constexpr double min_share = 0.97;
  std::vector<float> some;
  for (std::size_t i = 0; i < coordinates.size();
       i += coordinates.size() / looked_at + 1)
    some.push_back (coordinates[i]);
  std::sort (some.begin(), some.end());
  std::vector<float> shared;
  std::size_t on_shared = 0;
  for (auto begin = some.begin(); begin != some.end();) {
    const auto end = std::upper_bound (begin, some.end(), *begin);
    const auto points = static_cast<std::size_t> (end - begin);
    if (points >= min_points_of_a_value) {
      shared.push_back (*begin);
      on_shared += points;
    }
    begin = end;
  }
  const bool has_steps =
      shared.size() >= min_values &&
      static_cast<double> (on_shared) >= min_share * static_cast<double> (some.size());
  return has_steps ? shared : std::vector<float>();
}

// The width of the step that a coordinate lies in.
double
widthAt (const std::vector<float>& values, double coordinate)
{
  const auto above =
      std::lower_bound (values.begin(), values.end(), static_cast<float> (coordinate));
  return above == values.begin() || above == values.end() ? 0.0 : *above - *(above - 1);
}

} // namespace

CoordinateSteps::CoordinateSteps (const CurvePoints& points)
: values_{sharedValues (points.x), sharedValues (points.y), sharedValues (points.z)}
{}

double
CoordinateSteps::at (const Eigen::Vector3d& place, double edge) const
{
  // A place may lie on a value: both steps beside it count.
  constexpr double beside = 1e-4;
  double widest = 0.0;
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-beside, beside}) {
      const double width = widthAt (values_[axis], place[axis] + side * edge);
      if (width < edge)
        widest = std::max (widest, width);
    }
  return widest;
}

} // namespace pcl_ops::internal
