// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "search/nearest_candidates.h"

#include <limits>

using namespace pcl_ops::internal;

TEST (NearestCandidates, StopTakingWhatIsFarther)
{
  NearestCandidates candidates (1, std::numeric_limits<float>::infinity());
  EXPECT_TRUE (candidates.mayTake (NearestCandidates::bitsOf (5.0f)));
  const std::vector<float> near (50, 1.0f);
  const pcl::Indices indices (50, 7);
  candidates.add (near.data(), indices.data(), 50);
  EXPECT_FALSE (candidates.mayTake (NearestCandidates::bitsOf (5.0f)));
}
