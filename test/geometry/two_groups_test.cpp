// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "geometry/two_groups.h"

using namespace pcl_ops::internal;

TEST (BestTwoGroups, OfTwoDifferentValuesExplainAllOfTheVariance)
{
  const TwoGroups groups = bestTwoGroups ({1.0, 1.0, 1.0, 4.0, 4.0});
  EXPECT_EQ (groups.first_above, 3u);
  EXPECT_DOUBLE_EQ (groups.apart, 3.0);
  EXPECT_DOUBLE_EQ (groups.explained_share, 1.0);
}

TEST (BestTwoGroups, OfEvenlySpreadValuesAreHalvesThatExplain3QuartersOfTheVariance)
{
  std::vector<double> values;
  for (int i = 0; i < 1000; ++i)
    values.push_back (i);
  const TwoGroups groups = bestTwoGroups (values);
  EXPECT_EQ (groups.first_above, 500u);
  EXPECT_NEAR (groups.explained_share, 0.75, 1e-3);
}

TEST (BestTwoGroups, HaveAsManyValuesEachAsAreAskedFor)
{
  const std::vector<double> with_outlier{0.0, 1.0, 2.0, 3.0, 100.0};
  EXPECT_EQ (bestTwoGroups (with_outlier).first_above, 4u);
  EXPECT_EQ (bestTwoGroups (with_outlier, 2).first_above, 3u);
  EXPECT_EQ (bestTwoGroups (with_outlier, 3).first_above, 0u)
      << "five values are too few for two groups of three";
  EXPECT_EQ (bestTwoGroups (with_outlier, 3).explained_share, 0.0);
}

TEST (BestTwoGroups, OfEqualValuesOrNoneAreNone)
{
  EXPECT_EQ (bestTwoGroups ({2.0, 2.0, 2.0}).explained_share, 0.0);
  EXPECT_EQ (bestTwoGroups ({}).explained_share, 0.0);
}
