// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "region_growing.h"
#include <evaluation/data/data_sets.h>

namespace pcl_ops::evaluation {

/** \brief Where the truth of a cloud comes from that has none. */
struct TruthParameters {
  RegionGrowingParameters growing;
  /** \brief True planes with fewer points are none, whatever the truth's source. */
  std::size_t min_points = 50;
};

/** \brief The exact truth of a cloud, or else the one grown from it. */
PlaneLabels
truthOf (const EvaluationCloud& cloud, const TruthParameters& parameters);

/** \brief Name of a truth that came with the cloud. */
constexpr const char* exact_truth = "exact";

/** \brief How the truth of a cloud was had: \ref exact_truth, or "grown-k100" with its
 * number of neighbors. */
std::string
truthName (const EvaluationCloud& cloud, const TruthParameters& parameters);

} // namespace pcl_ops::evaluation
