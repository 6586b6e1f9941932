// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "methods.h"

#include "fspf_method.h"
#include "kht_method.h"
#include "ops_method.h"

#include <algorithm>
#include <numeric>

namespace pcl_ops::apps {

std::vector<std::uint32_t>
labelsOf (const std::vector<PlaneSegment>& planes, std::size_t points)
{
  std::vector<std::uint32_t> ids (planes.size());
  std::iota (ids.begin(), ids.end(), 1U);
  return labelsOf (planes, ids, points);
}

std::vector<std::uint32_t>
labelsOf (const std::vector<PlaneSegment>& planes,
          const std::vector<std::uint32_t>& ids,
          std::size_t points)
{
  std::vector<std::uint32_t> labels (points, 0);
  for (std::size_t i = 0; i < planes.size(); ++i)
    for (const pcl::index_t index : planes[i].inliers)
      labels[static_cast<std::size_t> (index)] = ids[i];
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
