// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "buildings/upright.h"

#include <vector>

namespace pcl_ops::internal::buildings {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/** \brief Up axes of any direction and length; the first and the last are along z. */
const std::vector<Vector3d> all_ups{{0.0, 0.0, 1.0},
                                    {0.3, -0.4, 0.8},
                                    {0.0, -1.0, 0.0},
                                    {0.2, 0.3, -0.5},
                                    {0.01, 0.02, -1.0},
                                    {0.0, 0.0, -2.0}};

TEST (TurnUpright, TurnsUpToZAndMirrorsNothing)
{
  for (const Vector3d& up : all_ups) {
    const Matrix3d turn = turnUpright (up);
    EXPECT_TRUE ((turn * up.normalized()).isApprox (Vector3d::UnitZ(), 1e-12)) << up;
    EXPECT_TRUE ((turn * turn.transpose()).isApprox (Matrix3d::Identity(), 1e-12))
        << up;
    EXPECT_NEAR (turn.determinant(), 1.0, 1e-12) << up;
  }
}

TEST (TurnUpright, TurnsTheShortestWay)
{
  // Where up is along z any axis will do. all_ups[4] is nearly -z, where half a turn
  // about x comes first.
  for (const Vector3d& up : {all_ups[1], all_ups[2], all_ups[3]}) {
    const Vector3d axis = up.cross (Vector3d::UnitZ());
    EXPECT_TRUE ((turnUpright (up) * axis).isApprox (axis, 1e-12)) << up;
  }
}

TEST (TurnUpright, TurnsNothingWhereUpIsZ)
{
  EXPECT_EQ (turnUpright ({0.0, 0.0, 3.0}), Matrix3d::Identity());
}

} // namespace
} // namespace pcl_ops::internal::buildings
