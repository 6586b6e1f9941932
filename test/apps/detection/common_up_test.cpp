// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <detection/common_up.h>

namespace {

using namespace pcl_ops;
using namespace pcl_ops::apps;

const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), z = Eigen::Vector3d::UnitZ();

TEST (CommonUp, IsWhatMostAnswersAgreeOn)
{
  // The axis and the confidence of each answer.
  const auto found = commonUp ({{z, 0.8}, {x, 0.9}, {z, 0.8}});
  ASSERT_TRUE (found);
  EXPECT_TRUE (found->axis.direction.isApprox (z));
  EXPECT_EQ (found->agreeing, 2u);
  EXPECT_NEAR (found->axis.confidence, (0.8 + 0.8) / (0.8 + 0.9 + 0.8), 1e-9);
}

TEST (CommonUp, IsTheMeanOfAnswersThatAreOffALittle)
{
  const Eigen::Vector3d left = (z + 0.1 * x).normalized(),
                        right = (z - 0.1 * x).normalized();
  const auto found = commonUp ({{left, 0.8}, {right, 0.8}});
  ASSERT_TRUE (found);
  EXPECT_TRUE (found->axis.direction.isApprox (z));
  EXPECT_EQ (found->axis.confidence, 1.0);
}

TEST (CommonUp, IsUnknownWhereAnswersContradictEachOther)
{
  EXPECT_FALSE (commonUp ({{z, 0.8}, {-z, 0.8}}));
}

TEST (CommonUp, IsUnknownWhereHalfOfTheAnswersAgreeHoweverSureTheyAre)
{
  EXPECT_FALSE (commonUp ({{z, 0.9}, {x, 0.8}}));
  EXPECT_FALSE (commonUp ({{z, 0.9}, {x, 0.3}, {-z, 0.3}}));
  EXPECT_TRUE (commonUp ({{z, 0.9}}));
}

TEST (CommonUp, IsUnknownWithoutAnswers) { EXPECT_FALSE (commonUp ({})); }

} // namespace
