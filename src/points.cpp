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
  return (std::abs (x) <= largest) & (std::abs (y) <= largest) &
         (std::abs (z) <= largest);
}

} // namespace

std::size_t
keepFinite (const pcl::index_t* index,
            std::size_t number,
            const PositionsOut& positions,
            pcl::index_t* kept)
{
  int all_finite = 1;
  for (std::size_t i = 0; i < number; ++i)
    all_finite &= isFinite (positions.x[i], positions.y[i], positions.z[i]) ? 1 : 0;
  if (all_finite) {
    std::copy_n (index, number, kept);
    return number;
  }
  std::size_t left = 0;
  for (std::size_t i = 0; i < number; ++i) {
    const float x = positions.x[i], y = positions.y[i], z = positions.z[i];
    // Written always, counted if finite: no branch to mispredict.
    positions.x[left] = x;
    positions.y[left] = y;
    positions.z[left] = z;
    kept[left] = index[i];
    left += isFinite (x, y, z);
  }
  return left;
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
