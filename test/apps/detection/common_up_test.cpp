// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <detection/common_up.h>

namespace {

using namespace pcl_ops;
using namespace pcl_ops::apps;

const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), z = Eigen::Vector3d::UnitZ();

// The arguments of commonUp are up axes of single clouds, each with its confidence.

TEST (CommonUp, IsTheAxisOfMostClouds)
{
  const auto found = commonUp ({{z, 0.8}, {x, 0.9}, {z, 0.8}});
  ASSERT_TRUE (found);
  EXPECT_TRUE (found->axis.direction.isApprox (z));
  EXPECT_EQ (found->agreeing, 2u);
  EXPECT_NEAR (found->axis.confidence, (0.8 + 0.8) / (0.8 + 0.9 + 0.8), 1e-9);
}

TEST (CommonUp, IsTheMeanOfAxesThatDifferByAFewDegrees)
{
  const Eigen::Vector3d toward_x = (z + 0.1 * x).normalized(),
                        away_from_x = (z - 0.1 * x).normalized();
  const auto found = commonUp ({{toward_x, 0.8}, {away_from_x, 0.8}});
  ASSERT_TRUE (found);
  EXPECT_TRUE (found->axis.direction.isApprox (z));
  EXPECT_EQ (found->axis.confidence, 1.0);
}

TEST (CommonUp, IsUnknownWhereAxesAreOpposite)
{
  EXPECT_FALSE (commonUp ({{z, 0.8}, {-z, 0.8}}));
}

TEST (CommonUp, IsUnknownUnlessMoreThanHalfOfTheAxesAgreeWhateverTheirConfidence)
{
  EXPECT_FALSE (commonUp ({{z, 0.9}, {x, 0.8}}));
  EXPECT_FALSE (commonUp ({{z, 0.9}, {x, 0.3}, {-z, 0.3}}));
  EXPECT_TRUE (commonUp ({{z, 0.9}}));
}

TEST (CommonUp, IsUnknownWithoutAxes) { EXPECT_FALSE (commonUp ({})); }

} // namespace
