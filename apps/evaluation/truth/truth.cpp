// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "truth.h"

namespace pcl_ops::evaluation {

PlaneLabels
truthOf (const EvaluationCloud& cloud, const TruthParameters& parameters)
{
  PlaneLabels labels =
      cloud.truth ? *cloud.truth : growRegions (*cloud.cloud, parameters.growing);
  dropSmallPlanes (labels, parameters.min_points);
  return labels;
}

std::string
truthName (const EvaluationCloud& cloud, const TruthParameters& parameters)
{
  if (cloud.truth)
    return exact_truth;
  return "grown-k" + std::to_string (parameters.growing.neighbors);
}

} // namespace pcl_ops::evaluation
