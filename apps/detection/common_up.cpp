// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "common_up.h"

#include <numbers/angles.h>

#include <cmath>

namespace pcl_ops::apps {

std::optional<CommonUp>
commonUp (const std::vector<UpAxis>& axes)
{
  // The largest angle between the axes of a group and its candidate, chosen by hand:
  // each of them may differ from the true axis by half of this angle.
  constexpr double max_degrees_apart = 15.0;
  const double min_cosine = std::cos (toRadians (max_degrees_apart));
  // In these groups the direction is a weighted sum, and the confidence is a sum.
  CommonUp best{{Eigen::Vector3d::Zero(), 0.0}, 0};
  double confidence_of_all = 0.0;
  for (const UpAxis& candidate : axes) {
    confidence_of_all += candidate.confidence;
    CommonUp group{{Eigen::Vector3d::Zero(), 0.0}, 0};
    for (const UpAxis& axis : axes)
      if (axis.direction.dot (candidate.direction) >= min_cosine) {
        group.axis.direction += axis.confidence * axis.direction;
        group.axis.confidence += axis.confidence;
        ++group.agreeing;
      }
    if (group.axis.confidence > best.axis.confidence)
      best = group;
  }
  const bool is_majority =
      2.0 * best.axis.confidence > confidence_of_all && 2 * best.agreeing > axes.size();
  if (!is_majority)
    return std::nullopt;
  best.axis.direction.normalize();
  best.axis.confidence /= confidence_of_all;
  return best;
}

} // namespace pcl_ops::apps
