// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cli/errors.h>
#include <tiles/plan.h>

using namespace pcl_ops::apps;
using Eigen::Vector3d;

namespace {

/** \brief 50 x 50 places of a floor of 5 m x 5 m. */
std::vector<Vector3d>
floorPlaces ()
{
  std::vector<Vector3d> places;
  for (int x = 0; x < 50; ++x)
    for (int y = 0; y < 50; ++y)
      places.emplace_back (0.1 * x, 0.1 * y, 0.0);
  return places;
}

constexpr std::uint64_t points = 50'000;

} // namespace

TEST (CellEdge, HoldsSomeTwentyPoints)
{
  // 2,000 points on a square meter: 20 on 10 cm x 10 cm.
  EXPECT_NEAR (cellEdgeFor (floorPlaces(), Vector3d::Zero(), points), 0.1, 0.05);
}

TEST (CellEdge, IsThatOfTheOthersWhereMostPlacesAreOne)
{
  std::vector<Vector3d> places = floorPlaces();
  const double edge = cellEdgeFor (places, Vector3d::Zero(), points);
  const Vector3d usual (1, 1, 0);
  places.insert (places.end(), 20'000, usual);
  EXPECT_NEAR (cellEdgeFor (places, usual, points), edge, 0.5 * edge);
}

TEST (CellEdge, HasToBeGivenForOnePlace)
{
  const std::vector<Vector3d> places (100, Vector3d (1, 2, 3));
  EXPECT_THROW (cellEdgeFor (places, Vector3d::Zero(), points), WorkError);
}
