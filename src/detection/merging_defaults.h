// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/plane_detector.h>

namespace pcl_ops::internal {

/** \brief The merging process with theta_h where it has no distance of its own (the
 * paper); theta_h is given. */
inline MergingParameters
mergingOf (const PlaneDetectorParameters& parameters)
{
  MergingParameters merging = parameters.merging;
  if (!merging.distance_threshold)
    merging.distance_threshold = *parameters.distance_threshold;
  return merging;
}

} // namespace pcl_ops::internal
