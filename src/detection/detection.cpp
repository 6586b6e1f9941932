// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_ops/detail/detection.h>

#include <algorithm>
#include <stdexcept>
#include <type_traits>

namespace pcl_ops::detail {

namespace {

// Negative ones are the largest. Without a way out of the loop, so that it is
// vectorized.
std::size_t
largestOf (const pcl::Indices& indices)
{
  using Number = std::make_unsigned_t<pcl::index_t>;
  Number largest = 0;
  for (const pcl::index_t index : indices)
    largest = std::max (largest, static_cast<Number> (index));
  return largest;
}

} // namespace

std::string
validate (const DetectorInput& input)
{
  if (input.cloud.size == 0)
    return "the input cloud is empty";
  if (input.indices.empty())
    return "the indices are empty; leave them out to use the whole cloud";
  if (largestOf (input.indices) >= input.cloud.size)
    return "an index lies outside the input cloud";
  return {};
}

void
throwOn (const std::string& problem)
{
  if (!problem.empty())
    throw std::invalid_argument (problem);
}

} // namespace pcl_ops::detail
