// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "geometry/float_plane.h"

using pcl_ops::Plane;
using namespace pcl_ops::internal;

namespace {

const FloatPlane one_metre_up (Plane{Eigen::Vector3d::UnitZ(), -1.0});

Coordinates
pointsAtHeights (const std::vector<float>& heights)
{
  Coordinates points;
  for (const float z : heights)
    points.add (7.0f, 8.0f, z);
  return points;
}

} // namespace

TEST (FloatPlane, HasUnsignedDistances)
{
  EXPECT_EQ (one_metre_up.distance (7, 8, 3), 2.0f);
  EXPECT_EQ (one_metre_up.distance (7, 8, -1), 2.0f);
}

TEST (FloatPlane, VisitsEveryPointWithItsDistance)
{
  std::vector<float> distances;
  forDistances (one_metre_up,
                pointsAtHeights ({1, 2, 4}),
                [&] (std::size_t, float distance) { distances.push_back (distance); });
  EXPECT_EQ (distances, (std::vector<float>{0, 1, 3}));
}

TEST (FloatPlane, VisitsTheAskedForPointsOnly)
{
  std::vector<std::size_t> visited;
  forDistances (
      one_metre_up, pointsAtHeights ({1, 2, 4, 8}), 1, 3, [&] (std::size_t i, float) {
        visited.push_back (i);
      });
  EXPECT_EQ (visited, (std::vector<std::size_t>{1, 2}));
}
