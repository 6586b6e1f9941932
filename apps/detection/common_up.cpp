// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "common_up.h"

#include <numbers/angles.h>

#include <cmath>

namespace pcl_ops::apps {

std::optional<CommonUp>
commonUp (const std::vector<UpAxis>& answers)
{
  // Twice what a single answer is off by, at most.
  const double min_cosine = std::cos (toRadians (15.0));
  CommonUp best{{Eigen::Vector3d::Zero(), 0.0}, 0};
  double weight = 0.0;
  for (const UpAxis& candidate : answers) {
    weight += candidate.confidence;
    CommonUp found{{Eigen::Vector3d::Zero(), 0.0}, 0};
    for (const UpAxis& answer : answers)
      if (answer.direction.dot (candidate.direction) >= min_cosine) {
        found.axis.direction += answer.confidence * answer.direction;
        found.axis.confidence += answer.confidence;
        ++found.answers;
      }
    if (found.axis.confidence > best.axis.confidence)
      best = found;
  }
  if (best.answers == 0 || 2.0 * best.axis.confidence <= weight)
    return std::nullopt;
  best.axis.direction.normalize();
  best.axis.confidence /= weight;
  return best;
}

} // namespace pcl_ops::apps
