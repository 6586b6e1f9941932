// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fspf/spheres.h"
#include "grid_scene.h"

using namespace pcl_ops;
using namespace pcl_ops::internal;

namespace {

const pcl::Indices some{0, 2, 4, 6, 7, 8};

DetectorInput
without (const CloudView& cloud = {})
{
  return {cloud, some, Eigen::Vector3d::Zero(), nullptr};
}

Spheres
spheresAmong (const Coordinates& coordinates, double radius)
{
  Points points;
  static_cast<Coordinates&> (points) = coordinates;
  return spheresAround (without(), points, radius, 1);
}

Indices
bruteForce (const Coordinates& points, std::uint32_t centre, double radius)
{
  Indices neighbors;
  for (std::uint32_t i = 0; i < points.size(); ++i)
    if ((points[i] - points[centre]).norm() <= radius)
      neighbors.push_back (i);
  return neighbors;
}

std::vector<float>
sorted (std::vector<float> numbers)
{
  std::sort (numbers.begin(), numbers.end());
  return numbers;
}

bool
isSubset (const Indices& part, const Indices& all)
{
  return std::includes (all.begin(), all.end(), part.begin(), part.end());
}

/** There is a sphere around every point, the one found by looking at all points but for
 * those so near its surface that rounding decides. */
void
expectFindsAll (const Coordinates& points, double radius)
{
  const double rounding = 1e-5 * radius;
  const Spheres spheres = spheresAmong (points, radius);
  EXPECT_EQ (sorted (spheres.points.x), sorted (points.x)) << "in another order";
  Indices sphere{99, 98, 97};
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    spheres.find (i, sphere);
    std::sort (sphere.begin(), sphere.end());
    EXPECT_TRUE (isSubset (bruteForce (spheres.points, i, radius - rounding), sphere));
    EXPECT_TRUE (isSubset (sphere, bruteForce (spheres.points, i, radius + rounding)));
  }
}

} // namespace

TEST (Spheres, HoldWhatLookingAtAllPointsFinds)
{
  for (const double radius : {1_cm, 5_cm, 20_cm, 3_m})
    expectFindsAll (pointsInACube (1000, 1_m), radius);
  expectFindsAll ({}, 10_cm);
}

TEST (Spheres, HoldDuplicatesAndAllBesidePointsFarAway)
{
  Coordinates equal, points = pointsInACube (500, 1_m);
  for (int i = 0; i < 5; ++i)
    equal.add (1, 2, 3);
  expectFindsAll (equal, 1_mm);
  points.add (1e7f, 0, 0);
  points.add (-1e12f, 1e12f, 0);
  expectFindsAll (points, 10_cm);
}

TEST (Spheres, AreThoseOfTheUsersSearchWhereThereIsOne)
{
  pcl::PointCloud<pcl::PointXYZ> cloud;
  for (int i = 0; i < 10; ++i)
    cloud.push_back ({static_cast<float> (i), 0, 0});
  DetectorInput input = without (CloudView (cloud));
  input.search_over = [] (const pcl::Indices&) {
    NeighborSearch search;
    search.within = [] (pcl::index_t point, double radius, auto& found, auto&) {
      EXPECT_EQ (point, 7);
      EXPECT_EQ (radius, 1.5);
      found = {4, 5, 7}; // 5 is none of ours
    };
    return search;
  };
  const Points points = finitePoints (input.cloud, some, 1);
  Indices sphere;
  spheresAround (input, points, 1.5, 1).find (4, sphere);
  EXPECT_EQ (sphere, (Indices{2, 4})) << "positions of 4 and 7 among them";
}
