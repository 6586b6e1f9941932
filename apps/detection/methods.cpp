// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "methods.h"

#include "fspf_method.h"
#include "kht_method.h"
#include "ops_method.h"

#include <algorithm>

namespace pcl_ops::apps {

std::vector<std::uint32_t>
labelsOf (const std::vector<PlaneSegment>& planes, std::size_t points)
{
  std::vector<std::uint32_t> labels (points, 0);
  std::uint32_t id = 0;
  for (const PlaneSegment& plane : planes) {
    ++id;
    for (const pcl::index_t index : plane.inliers)
      labels[static_cast<std::size_t> (index)] = id;
  }
  return labels;
}

const std::vector<Method>&
allMethods ()
{
  static const std::vector<Method> methods = {opsMethod(), fspfMethod(), khtMethod()};
  return methods;
}

const Method&
methodCalled (const std::string& name)
{
  const auto& methods = allMethods();
  return *std::find_if (methods.begin(), methods.end(), [&] (const Method& method) {
    return method.name == name;
  });
}

} // namespace pcl_ops::apps
