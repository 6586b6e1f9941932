// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "exact_moments.h"

#include <cmath>

namespace pcl_ops::apps {

namespace {

using Whole = ExactMoments::Whole;

constexpr std::array<std::array<std::size_t, 2>, 6> axes = {
    {{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}}};

} // namespace

void
ExactMoments::add (const Eigen::Vector3d& place)
{
  std::array<std::int64_t, 3> p{};
  for (int axis = 0; axis < 3; ++axis) {
    p[axis] = std::llround (place[axis] / unit);
    sum[axis] += p[axis];
  }
  for (std::size_t k = 0; k < axes.size(); ++k)
    products[k] += static_cast<Whole> (p[axes[k][0]]) * p[axes[k][1]];
  ++count;
}

ExactMoments&
ExactMoments::operator+= (const ExactMoments& other)
{
  count += other.count;
  for (std::size_t axis = 0; axis < sum.size(); ++axis)
    sum[axis] += other.sum[axis];
  for (std::size_t k = 0; k < products.size(); ++k)
    products[k] += other.products[k];
  return *this;
}

Moments
ExactMoments::toMoments() const
{
  Moments moments;
  if (count == 0)
    return moments;
  const auto n = static_cast<Whole> (count);
  std::array<Whole, 3> origin{}, about{};
  for (std::size_t axis = 0; axis < sum.size(); ++axis) {
    origin[axis] = sum[axis] / n;
    about[axis] = sum[axis] - n * origin[axis];
    moments.origin[static_cast<int> (axis)] = unit * static_cast<double> (origin[axis]);
    moments.sum[static_cast<int> (axis)] = unit * static_cast<double> (about[axis]);
  }
  moments.count = static_cast<double> (count);
  for (std::size_t k = 0; k < axes.size(); ++k) {
    const auto [i, j] = axes[k];
    // S_ij - o_i S_j - o_j S_i + n o_i o_j, of which the last two are -o_j r_i
    const Whole central = products[k] - origin[i] * sum[j] - about[i] * origin[j];
    moments.products[k] = unit * unit * static_cast<double> (central);
  }
  return moments;
}

double
latticeFor (double cell)
{
  constexpr double units_of_cell = 1e4;
  return std::exp2 (std::floor (std::log2 (cell / units_of_cell)));
}

} // namespace pcl_ops::apps
