// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <evaluation/labels/plane_classes.h>

#include <string>
#include <vector>

namespace pcl_ops::benchmark {

/** \brief A cloud that a detector could take long for. */
struct WorstCloud {
  std::string name;
  /** \brief With about so many points, the same each time. */
  evaluation::XyzCloud::Ptr (*make) (std::size_t points);
};

/** \brief Clouds as no sensor makes them: noise, planes without noise, as many planes
 * as there can be, points on all scales, points in one place. As large as a room where
 * that leaves a choice. */
const std::vector<WorstCloud>&
worstClouds ();

} // namespace pcl_ops::benchmark
