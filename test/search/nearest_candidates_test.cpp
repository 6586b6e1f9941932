// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "search/nearest_candidates.h"

using namespace pcl_ops::internal;

namespace {

constexpr float far_away = std::numeric_limits<float>::infinity();

/** \brief The nearest of 100 points at squared distances of 99, 98 .. 0. */
pcl::Indices
nearest (std::size_t most, float squared_radius)
{
  NearestCandidates candidates (most, squared_radius);
  for (pcl::index_t i = 0; i < 100; ++i) {
    const auto squared_distance = static_cast<float> (99 - i);
    candidates.add (&squared_distance, &i, 1);
  }
  pcl::Indices indices;
  std::vector<float> squared_distances;
  candidates.take (true, indices, squared_distances);
  for (std::size_t i = 0; i < indices.size(); ++i)
    EXPECT_EQ (squared_distances[i], static_cast<float> (99 - indices[i]));
  return indices;
}

} // namespace

TEST (NearestCandidates, AreTheNearestOfAll)
{
  EXPECT_EQ (nearest (3, far_away), (pcl::Indices{99, 98, 97}));
}

TEST (NearestCandidates, AreWithinTheRadius)
{
  EXPECT_EQ (nearest (100, 2.0f), (pcl::Indices{99, 98, 97})) << "the radius included";
}

TEST (NearestCandidates, AreAllWhereThereAreNoMore)
{
  EXPECT_EQ (nearest (1000, far_away).size(), 100u);
}

TEST (NearestCandidates, StopTakingWhatIsFarther)
{
  NearestCandidates candidates (1, far_away);
  EXPECT_TRUE (candidates.mayTake (5.0f));
  const std::vector<float> near (50, 1.0f);
  const pcl::Indices indices (50, 7);
  candidates.add (near.data(), indices.data(), 50);
  EXPECT_FALSE (candidates.mayTake (5.0f));
}
