// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <pcl_ops/plane.h>
#include <simulation/town.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace {

using namespace pcl_ops::simulation;

using Points = std::vector<TownPoint>;

/** \brief The points of all tiles, sorted. */
Points
allPoints (const Town& town)
{
  Points points;
  for (std::uint32_t row = 0; row < town.tiles; ++row)
    for (std::uint32_t column = 0; column < town.tiles; ++column)
      for (const TownPoint& point : surveyTile (town, column, row, 1.0))
        points.push_back (point);
  const auto key = [] (const TownPoint& point) {
    return std::array<double, 3>{
        point.position.x(), point.position.y(), point.position.z()};
  };
  std::sort (points.begin(), points.end(), [&] (const auto& a, const auto& b) {
    return key (a) < key (b);
  });
  return points;
}

constexpr double some_points = 1e5;

} // namespace

TEST (Town, HasTheSamePointsInAnyNumberOfTiles)
{
  const Points one = allPoints (makeTown (1, some_points, 1));
  const Points nine = allPoints (makeTown (1, some_points, 3));
  ASSERT_EQ (one.size(), nine.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    ASSERT_EQ (one[i].position, nine[i].position);
    ASSERT_EQ (one[i].label, nine[i].label);
  }
}

TEST (Town, HasAboutAsManyPointsAsAskedFor)
{
  constexpr double many_points = 1e6;
  const double found =
      static_cast<double> (allPoints (makeTown (1, many_points, 2)).size());
  EXPECT_NEAR (found / many_points, 1.0, 0.2);
}

TEST (Town, HasAPlaneForEachLabel)
{
  std::map<std::uint32_t, pcl_ops::Moments> planes;
  const Town town = makeTown (2, some_points, 1);
  for (const TownPoint& point : surveyTile (town, 0, 0, 1.0)) {
    pcl_ops::Moments& moments = planes[point.label];
    moments.origin = town.corner;
    const Eigen::Vector3d local = point.position - town.corner;
    moments.add (local.x(), local.y(), local.z());
  }
  EXPECT_GT (planes.size(), 10u);
  constexpr double fewest_points = 500;
  for (const auto& [label, moments] : planes) {
    const auto fit = pcl_ops::fitPlane (moments);
    if (moments.count < fewest_points)
      continue;
    ASSERT_TRUE (fit);
    EXPECT_NEAR (std::sqrt (fit->variances[0]), 0.015, 0.002) << label;
  }
}

TEST (Town, HasWallsAcrossTheBordersOfTiles)
{
  const Town town = makeTown (1, some_points, 2);
  const auto labelsOf = [&] (std::uint32_t column) {
    std::set<std::uint32_t> labels;
    for (const TownPoint& point : surveyTile (town, column, 0, 1.0))
      labels.insert (point.label);
    return labels;
  };
  const std::set<std::uint32_t> left = labelsOf (0), right = labelsOf (1);
  std::vector<std::uint32_t> both;
  std::set_intersection (
      left.begin(), left.end(), right.begin(), right.end(), std::back_inserter (both));
  EXPECT_GT (both.size(), 5u) << "the ground, and more";
}

TEST (Town, IsAnotherOneForAnotherSeed)
{
  const Points first = surveyTile (makeTown (1, some_points, 1), 0, 0, 1.0);
  const Points second = surveyTile (makeTown (2, some_points, 1), 0, 0, 1.0);
  EXPECT_NE (first.front().position, second.front().position);
}
