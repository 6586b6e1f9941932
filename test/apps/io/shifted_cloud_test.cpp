// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <io/shifted_cloud.h>
#include <support/text.h>

#include <cstdlib>
#include <limits>
#include <string>

using namespace pcl_ops::apps;

namespace {

constexpr int side = 100;

/** \brief A floor of 2 m by 2 m. */
XyzCloud
floorOfPoints ()
{
  XyzCloud cloud;
  for (int x = 0; x < side; ++x)
    for (int y = 0; y < side; ++y)
      cloud.emplace_back (
          0.02f * static_cast<float> (x), 0.02f * static_cast<float> (y), 0.0f);
  return cloud;
}

std::string
damageOf (const XyzCloud& cloud, const Eigen::Vector3d& shift = Eigen::Vector3d::Zero())
{
  return pcl_ops::apps::damageOf (ShiftedCloud{cloud.makeShared(), shift});
}

/** \brief Moves a share of a cloud's points, spread over it.
 * \param[in] one_of how many points there are for each that is moved */
XyzCloud
withMoved (XyzCloud cloud, int one_of, const pcl::PointXYZ& place, float step)
{
  float moved = 0.0f;
  for (std::size_t i = 0; i < cloud.size(); i += static_cast<std::size_t> (one_of)) {
    cloud[i] = place;
    cloud[i].x += step * moved++;
  }
  return cloud;
}

} // namespace

TEST (CloudDamage, IsNoneOfUsualClouds)
{
  constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
  XyzCloud missing = floorOfPoints(), dense_spot;
  for (std::size_t i = 0; i < 9000; ++i)
    missing[i] = {not_a_number, not_a_number, not_a_number};
  for (int i = -5000; i <= 5000; ++i) {
    const auto place = static_cast<float> (i);
    const bool is_in_spot = std::abs (i) < 1000;
    dense_spot.emplace_back (is_in_spot ? 1e-6f * place : place, 0.0f, 0.0f);
  }
  const XyzCloud floor = floorOfPoints();
  const std::pair<const char*, XyzCloud> rows[] = {
      {"a floor", floor},
      {"a handful of points", XyzCloud (3, 1, {1.0f, 2.0f, 3.0f})},
      {"no points", XyzCloud()},
      {"most readings are missing", missing},
      {"most points are far from a dense spot", dense_spot},
      {"a third at one place", withMoved (floor, 3, {0.0f, 0.0f, 0.0f}, 0.0f)},
      {"few are far away", withMoved (floor, 1000, {1e6f, 0, 0}, 1e3f)},
      {"one per cent is not that far", withMoved (floor, 97, {1e3f, 0, 0}, 1.0f)}};
  for (const auto& [name, cloud] : rows)
    EXPECT_EQ (damageOf (cloud), "") << name;
}

TEST (CloudDamage, IsSeenWhereMostPointsAreAtOnePlace)
{
  XyzCloud cloud = floorOfPoints();
  for (std::size_t i = 0; i < 6000; ++i)
    cloud[i] = {1.0f, 0.0f, 0.0f};
  EXPECT_EQ (
      damageOf (cloud),
      "looks damaged: 60 % of its points are at (1, 0, 0); leave missing readings "
      "out or write them as NaN");
}

TEST (CloudDamage, IsAtThePlaceOfTheFileToTheMillimeter)
{
  XyzCloud cloud = floorOfPoints();
  for (std::size_t i = 0; i < 6000; ++i)
    cloud[i] = {1.0f, 0.0f, -0.5f};
  const std::string text =
      damageOf (cloud, Eigen::Vector3d (512345.001, 5412345.002, 99.003));
  EXPECT_TRUE (contains (text, "are at (512346.001, 5412345.002, 98.503);"));
}

TEST (CloudDamage, IsOfAHundredPerCentWhereAllPointsAreAtOnePlace)
{
  const std::string text = damageOf (XyzCloud (100, 1, {1.0f, 2.0f, 3.0f}));
  EXPECT_TRUE (contains (text, "looks damaged: 100 % of its points are at (1, 2, 3);"));
  XyzCloud but_few = XyzCloud (1000, 1, {1.0f, 2.0f, 3.0f});
  for (std::size_t i = 0; i < 4; ++i)
    but_few[i].x += static_cast<float> (i);
  EXPECT_TRUE (contains (damageOf (but_few), "looks damaged: 99.7 % of"));
}

TEST (CloudDamage, IsSeenAmongThePointsThatHaveCoordinates)
{
  constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
  XyzCloud cloud = floorOfPoints();
  for (std::size_t i = 0; i < 9000; ++i)
    cloud[i] = i % 3 == 0 ? pcl::PointXYZ (0.0f, 0.0f, 0.0f)
                          : pcl::PointXYZ (not_a_number, not_a_number, not_a_number);
  EXPECT_TRUE (contains (damageOf (cloud), "75 % of its points are at (0, 0, 0)"));
}

TEST (CloudDamage, IsSeenWhereOnePerCentIsVeryFarAway)
{
  // Each in a kilometer of its own, 1,000 km away.
  const std::string text =
      damageOf (withMoved (floorOfPoints(), 97, {1e6f, 0, 0}, 1e3f));
  EXPECT_TRUE (contains (text, "1000 times as far away as the rest is wide"));
}
