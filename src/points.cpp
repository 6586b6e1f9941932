// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_ops/points.h>

#include <algorithm>
#include <functional>

namespace pcl_ops {

void
sortOnce (pcl::Indices& indices)
{
  if (std::adjacent_find (indices.begin (), indices.end (), std::greater_equal<> ()) ==
      indices.end ())
    return;
  std::sort (indices.begin (), indices.end ());
  indices.erase (std::unique (indices.begin (), indices.end ()), indices.end ());
}

double
medianOf (std::vector<float>& values)
{
  if (values.empty ())
    return 0.0;
  const auto middle = values.begin () + static_cast<std::ptrdiff_t> (values.size () / 2);
  std::nth_element (values.begin (), middle, values.end ());
  return *middle;
}

} // namespace pcl_ops
