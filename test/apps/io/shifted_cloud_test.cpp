// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <io/shifted_cloud.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <string>

using namespace pcl_ops::apps;

namespace {

/** \brief A floor of 2 m x 2 m, with 100 x 100 points. */
XyzCloud
floorOfPoints ()
{
  constexpr int side = 100;
  XyzCloud cloud;
  for (int x = 0; x < side; ++x)
    for (int y = 0; y < side; ++y)
      cloud.emplace_back (
          0.02f * static_cast<float> (x), 0.02f * static_cast<float> (y), 0.0f);
  return cloud;
}

/** \brief Moves some points, spread over the cloud, to other positions.
 * \param[in] one_of one of this many points is moved
 * \param[in] first new position of the first moved point
 * \param[in] step distance along x from each new position to the next one [m] */
XyzCloud
withMoved (XyzCloud cloud, int one_of, const pcl::PointXYZ& first, float step)
{
  float moved = 0.0f;
  for (std::size_t i = 0; i < cloud.size(); i += static_cast<std::size_t> (one_of)) {
    cloud[i] = first;
    cloud[i].x += step * moved++;
  }
  return cloud;
}

/** \brief For \ref withMoved: 104 of 10,000 points. */
constexpr int one_of_for_one_per_cent = 97;

const pcl::PointXYZ no_reading (std::numeric_limits<float>::quiet_NaN(),
                                std::numeric_limits<float>::quiet_NaN(),
                                std::numeric_limits<float>::quiet_NaN());

std::string
damage (const XyzCloud& cloud, const Eigen::Vector3d& shift = {0, 0, 0})
{
  return damageOf (ShiftedCloud{cloud.makeShared(), shift});
}

/** \brief The message about a share of a cloud's points that are at one place.
 * \param[in] share in percent */
std::string
atOnePlace (const std::string& share, const std::string& place)
{
  return "looks damaged: " + share + " % of its points are at " + place +
         "; leave missing readings out or write them as NaN";
}

/** \brief A floor of which 6,000 of 10,000 points are at (1, 0, -0.5). */
XyzCloud
floorMostlyAtOnePlace ()
{
  XyzCloud cloud = floorOfPoints();
  for (std::size_t i = 0; i < 6000; ++i)
    cloud[i] = {1.0f, 0.0f, -0.5f};
  return cloud;
}

} // namespace

TEST (CloudDamage, IsNoneOfAFloor) { EXPECT_EQ (damage (floorOfPoints()), ""); }

TEST (CloudDamage, IsNoneOfAHandfulOfEqualPoints)
{
  EXPECT_EQ (damage (XyzCloud (3, 1, {1.0f, 2.0f, 3.0f})), "");
}

TEST (CloudDamage, IsNoneOfAnEmptyCloud) { EXPECT_EQ (damage ({}), ""); }

TEST (CloudDamage, IsNoneWhereMostReadingsAreMissing)
{
  XyzCloud cloud = floorOfPoints();
  std::fill_n (cloud.begin(), 9000, no_reading);
  EXPECT_EQ (damage (cloud), "");
}

TEST (CloudDamage, IsNoneWhereMostPointsAreFarFromADenseSpot)
{
  XyzCloud line;
  for (int i = -5000; i <= 5000; ++i) {
    const auto x = static_cast<float> (i);
    const bool is_in_spot = std::abs (i) < 1000;
    line.emplace_back (is_in_spot ? 1e-6f * x : x, 0.0f, 0.0f);
  }
  EXPECT_EQ (damage (line), "");
}

TEST (CloudDamage, IsNoneWhereOnePointInAThousandIsVeryFarAway)
{
  EXPECT_EQ (damage (withMoved (floorOfPoints(), 1000, {1e6f, 0, 0}, 1e3f)), "");
}

TEST (CloudDamage, IsNoneWhereOnePerCentIsAKilometerAway)
{
  EXPECT_EQ (
      damage (withMoved (floorOfPoints(), one_of_for_one_per_cent, {1e3f, 0, 0}, 1.0f)),
      "");
}

TEST (CloudDamage, IsSeenWhereOnePerCentIsAThousandKilometersAway)
{
  // The far points are a kilometer from each other.
  EXPECT_EQ (
      damage (withMoved (floorOfPoints(), one_of_for_one_per_cent, {1e6f, 0, 0}, 1e3f)),
      "looks damaged: 1 % of its points are more than 1000 times as far away as "
      "the rest is wide; leave them out");
}

TEST (CloudDamage, IsSeenWhereMostPointsAreAtOnePlace)
{
  EXPECT_EQ (damage (floorMostlyAtOnePlace()), atOnePlace ("60", "(1, 0, -0.5)"));
}

TEST (CloudDamage, NamesThePlaceInTheFrameOfTheFile)
{
  EXPECT_EQ (damage (floorMostlyAtOnePlace(), {512345.001, 5412345.002, 99.003}),
             atOnePlace ("60", "(512346.001, 5412345.002, 98.503)"));
}

TEST (CloudDamage, IsSeenWhereAllPointsAreAtOnePlace)
{
  EXPECT_EQ (damage (XyzCloud (100, 1, {1.0f, 2.0f, 3.0f})),
             atOnePlace ("100", "(1, 2, 3)"));
}

TEST (CloudDamage, IsSeenWhereNearlyAllPointsAreAtOnePlace)
{
  XyzCloud cloud (1000, 1, {1.0f, 2.0f, 3.0f});
  for (std::size_t i = 0; i < 4; ++i)
    cloud[i].x += static_cast<float> (i);
  EXPECT_EQ (damage (cloud), atOnePlace ("99.7", "(1, 2, 3)"));
}

TEST (CloudDamage, IsSeenWhereMostReadingsAreZero)
{
  XyzCloud cloud = floorOfPoints();
  for (std::size_t i = 0; i < 9000; ++i)
    cloud[i] = i % 3 == 0 ? pcl::PointXYZ (0.0f, 0.0f, 0.0f) : no_reading;
  EXPECT_EQ (damage (cloud), atOnePlace ("75", "(0, 0, 0)"));
}

TEST (CloudDamage, CountsMissingReadingsAtZeroIfTheyAreAPercentOrMore)
{
  const auto said = [] (const std::string& share) {
    return "is missing readings: " + share +
           " % of its points are at (0, 0, 0) and count as such; leave them out or "
           "write them as NaN";
  };
  const XyzCloud floor = floorOfPoints();
  const auto damageWithZeros = [&] (int one_of) {
    return damageOf ({withMoved (floor, one_of, {0, 0, 0}, 0.0f).makeShared()});
  };
  EXPECT_EQ (damageWithZeros (3), said ("33"));
  EXPECT_EQ (damageWithZeros (49), said ("2.1"));
  EXPECT_EQ (damageWithZeros (501), "");
  // Whole meters: nine places, zero among them, each of 6 to 25 % of the points.
  XyzCloud on_a_grid = floor;
  for (pcl::PointXYZ& point : on_a_grid)
    point.getVector3fMap() = point.getVector3fMap().array().round();
  EXPECT_EQ (damageOf ({on_a_grid.makeShared()}), "");
}
