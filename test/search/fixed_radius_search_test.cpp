// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "grid_scene.h"
#include "search/fixed_radius_search.h"

#include <set>
#include <tuple>

using namespace pcl_ops::internal;

namespace {

Indices
bruteForce (const Coordinates& points, std::uint32_t centre, double radius)
{
  Indices neighbours;
  for (std::uint32_t i = 0; i < points.size(); ++i)
    if ((points[i] - points[centre]).norm() <= radius)
      neighbours.push_back (i);
  return neighbours;
}

bool
isSubset (const Indices& part, const Indices& all)
{
  return std::includes (all.begin(), all.end(), part.begin(), part.end());
}

/** Every neighbourhood is the one found by looking at all points, but for those so near
 * the sphere's surface that rounding decides. */
void
expectFindsAll (const Coordinates& points, double radius)
{
  const double rounding = 1e-5 * radius;
  const FixedRadiusSearch search (points, radius, 1);
  Indices neighbours{99, 98, 97};
  const auto all_within = [&] (std::uint32_t i, double distance) {
    return bruteForce (search.points(), i, distance);
  };
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    search.find (i, neighbours);
    std::sort (neighbours.begin(), neighbours.end());
    EXPECT_TRUE (isSubset (all_within (i, radius - rounding), neighbours)) << i;
    EXPECT_TRUE (isSubset (neighbours, all_within (i, radius + rounding))) << i;
  }
}

std::multiset<std::tuple<float, float, float>>
setOf (const Coordinates& points)
{
  std::multiset<std::tuple<float, float, float>> set;
  for (std::size_t i = 0; i < points.size(); ++i)
    set.emplace (points.x[i], points.y[i], points.z[i]);
  return set;
}

} // namespace

TEST (FixedRadiusSearch, FindsWhatLookingAtAllPointsFinds)
{
  for (const double radius : {1_cm, 5_cm, 20_cm, 3_m})
    expectFindsAll (pointsInACube (1000, 1_m), radius);
}

TEST (FixedRadiusSearch, FindsThePointItselfAndItsDuplicates)
{
  Coordinates points;
  for (int i = 0; i < 5; ++i)
    points.add (1, 2, 3);
  expectFindsAll (points, 1_mm);
}

TEST (FixedRadiusSearch, FindsAllBesidePointsFarAway)
{
  Coordinates points = pointsInACube (500, 1_m);
  points.add (1e7f, 0, 0);
  points.add (-1e12f, 1e12f, 0);
  expectFindsAll (points, 10_cm);
}

TEST (FixedRadiusSearch, HoldsThePointsInAnotherOrder)
{
  const Coordinates points = pointsInACube (1000, 1_m);
  EXPECT_EQ (setOf (FixedRadiusSearch (points, 10_cm, 1).points()), setOf (points));
}

TEST (FixedRadiusSearch, OfNoPointsHoldsNone)
{
  EXPECT_EQ (FixedRadiusSearch (Coordinates(), 10_cm, 1).points().size(), 0u);
}
