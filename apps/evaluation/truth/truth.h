// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "region_growing.h"
#include <evaluation/data/data_sets.h>

namespace pcl_ops::evaluation {

/** \brief Where the truth of a cloud comes from that has none. */
struct TruthParameters {
  RegionGrowingParameters growing;
  /** \brief Folder where grown truth is kept from one run to the next; empty: nowhere.
   */
  std::string cache_folder;
  /** \brief True planes with fewer points are none, whatever the truth's source. */
  std::size_t min_points = 50;
};

/** \brief Name of a grown truth in the cache: it tells clouds and parameters apart. */
std::string
truthKey (const XyzCloud& cloud, const RegionGrowingParameters& parameters);

/** \brief The exact truth of a cloud, or else the one grown from it: read from the
 * cache, or grown and written there.
 * \throw apps::WorkError if the cache cannot be
 * written */
PlaneLabels
truthOf (const EvaluationCloud& cloud, const TruthParameters& parameters);

/** \brief Name of a truth that came with the cloud. */
constexpr const char* exact_truth = "exact";

/** \brief How the truth of a cloud was had: \ref exact_truth, or "grown-k100" with its
 * number of neighbors. */
std::string
truthName (const EvaluationCloud& cloud, const TruthParameters& parameters);

} // namespace pcl_ops::evaluation
