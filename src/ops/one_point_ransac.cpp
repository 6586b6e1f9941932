// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ops/one_point_ransac.h"

#include <cmath>
#include <limits>

namespace pcl_ops::internal {

std::size_t
requiredDraws (double probability, double inlier_ratio)
{
  if (!(inlier_ratio < 1.0))
    return 1;
  const double draws = std::log1p (-probability) / std::log1p (-inlier_ratio);
  constexpr auto most = static_cast<double> (std::numeric_limits<std::int32_t>::max());
  return static_cast<std::size_t> (draws > 0.0 && draws < most ? std::ceil (draws)
                                                               : most);
}

} // namespace pcl_ops::internal
