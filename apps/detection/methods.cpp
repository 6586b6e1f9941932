// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "methods.h"

#include <algorithm>

namespace pcl_ops::apps {

const std::vector<Method>&
allMethods ()
{
  static const std::vector<Method> kMethods = {opsMethod(), fspfMethod(), khtMethod()};
  return kMethods;
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
