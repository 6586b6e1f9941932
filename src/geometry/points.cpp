// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_ops/points.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace pcl_ops {

void
sortOnce (pcl::Indices& indices)
{
  if (areAscending (indices.data(), indices.size()))
    return;
  std::sort (indices.begin(), indices.end());
  indices.erase (std::unique (indices.begin(), indices.end()), indices.end());
}

bool
areConsecutive (const pcl::index_t* indices, std::size_t number)
{
  pcl::index_t different = 0;
  for (std::size_t i = 0; i < number; ++i)
    different |= (indices[i] - indices[0]) ^ static_cast<pcl::index_t> (i);
  return different == 0;
}

bool
areAscending (const pcl::index_t* indices, std::size_t number)
{
  return std::adjacent_find (indices, indices + number, std::greater_equal<>()) ==
         indices + number;
}

namespace {

bool
isFinite (float x, float y, float z)
{
  constexpr float largest = std::numeric_limits<float>::max();
  // Whole numbers, combined without a branch, so that the loops below vectorize.
  const int x_is_finite = std::abs (x) <= largest;
  const int y_is_finite = std::abs (y) <= largest;
  const int z_is_finite = std::abs (z) <= largest;
  return (x_is_finite & y_is_finite & z_is_finite) != 0;
}

} // namespace

bool
areFinite (const Coordinates& positions, std::size_t begin, std::size_t end)
{
  int all = 1;
  for (std::size_t i = begin; i < end; ++i)
    all &= isFinite (positions.x[i], positions.y[i], positions.z[i]) ? 1 : 0;
  return all != 0;
}

void
keepFinite (Points& points)
{
  std::size_t left = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const float x = points.x[i], y = points.y[i], z = points.z[i];
    // Written always, counted if finite: no branch to mispredict.
    points.x[left] = x;
    points.y[left] = y;
    points.z[left] = z;
    points.index[left] = points.index[i];
    left += isFinite (x, y, z);
  }
  points.resize (left);
  points.index.resize (left);
}

double
medianOf (std::vector<float>& values)
{
  if (values.empty())
    return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t> (values.size() / 2);
  std::nth_element (values.begin(), middle, values.end());
  return *middle;
}

} // namespace pcl_ops
