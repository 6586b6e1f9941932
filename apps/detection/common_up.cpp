// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "common_up.h"

#include <numbers/angles.h>

#include <cmath>

namespace pcl_ops::apps {

std::optional<CommonUp>
commonUp (const std::vector<UpAxis>& answers)
{
  // Two answers agree up to here: each may be off by half of it.
  constexpr double max_degrees_apart = 15.0;
  const double min_cosine = std::cos (toRadians (max_degrees_apart));
  CommonUp best{{Eigen::Vector3d::Zero(), 0.0}, 0};
  double confidence_of_all = 0.0;
  for (const UpAxis& candidate : answers) {
    confidence_of_all += candidate.confidence;
    CommonUp agreeing{{Eigen::Vector3d::Zero(), 0.0}, 0};
    for (const UpAxis& answer : answers)
      if (answer.direction.dot (candidate.direction) >= min_cosine) {
        agreeing.axis.direction += answer.confidence * answer.direction;
        agreeing.axis.confidence += answer.confidence;
        ++agreeing.answers;
      }
    if (agreeing.axis.confidence > best.axis.confidence)
      best = agreeing;
  }
  if (best.answers == 0 || 2.0 * best.axis.confidence <= confidence_of_all)
    return std::nullopt;
  best.axis.direction.normalize();
  best.axis.confidence /= confidence_of_all;
  return best;
}

} // namespace pcl_ops::apps
