// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/common/point_tests.h>
#include <pcl/search/kdtree.h>

#include "cloud/nearest_candidates.h"
#include "scene.h"
#include <pcl_ops/grid_search.h>

#include <functional>
#include <map>
#include <set>

using namespace pcl_ops::internal;
using pcl::PointXYZ;
using Cloud = pcl::PointCloud<PointXYZ>;
using Search = pcl_ops::GridSearch<PointXYZ>;

namespace {

Cloud::Ptr
randomCloud (std::size_t size, const std::function<PointXYZ (RandomGenerator&)>& draw)
{
  RandomGenerator generator (seedOfTest());
  auto cloud = pcl::make_shared<Cloud>();
  for (std::size_t i = 0; i < size; ++i)
    cloud->push_back (draw (generator));
  return cloud;
}

/** A point drawn uniformly in a cube centered at zero.
 * \param[in] edge of the cube [m] */
PointXYZ
drawInCube (RandomGenerator& generator, double edge)
{
  const auto draw = [&] {
    return static_cast<float> (edge * (drawUnit (generator) - 0.5));
  };
  const float x = draw(), y = draw(), z = draw();
  return {x, y, z};
}

Cloud::Ptr
uniformVolume ()
{
  return randomCloud (3000, [] (auto& g) { return drawInCube (g, 1_m); });
}

Cloud::Ptr
onePoint ()
{
  return randomCloud (1, [] (auto&) { return PointXYZ (1, 2, 3); });
}

/** Clouds by name, most of which are hard to search. */
std::map<std::string, Cloud::Ptr>
clouds ()
{
  const Cloud::Ptr broken = uniformVolume(), beside_strays = uniformVolume();
  for (std::size_t i = 0; i < broken->size(); i += 2)
    (*broken)[i].y = NAN;
  (*broken)[1].z = INFINITY;
  beside_strays->push_back ({1e7f, 0, 0});
  beside_strays->push_back ({-1e12f, 1e12f, 0});
  const auto drawClusters = [] (auto& g) {
    return drawInCube (g, drawUnit (g) < 0.9 ? 1_mm : 1000_m);
  };
  const auto drawDuplicates = [] (auto& g) {
    const auto i = static_cast<float> (drawBelow (g, 7));
    return PointXYZ (i, 2.0f * i, -i);
  };
  const auto drawLine = [] (auto& g) {
    const auto t = static_cast<float> (drawUnit (g));
    return PointXYZ (t, 2.0f * t, 3.0f * t);
  };
  // The same relative distance between neighbors at every scale.
  const auto drawSteps = [] (auto& g) {
    return drawInCube (g, std::pow (10.0, 12.0 * drawUnit (g) - 9.0));
  };
  const auto drawEqual = [] (auto&) { return PointXYZ (1, 2, 3); };
  Scene surfaces = room().spacing (10_cm);
  return {{"UniformVolume", uniformVolume()},
          {"Surfaces", surfaces.build().cloud},
          {"OnePoint", onePoint()},
          {"Clusters", randomCloud (4000, drawClusters)},
          {"Duplicates", randomCloud (2000, drawDuplicates)},
          {"AllEqual", randomCloud (1000, drawEqual)},
          {"Line", randomCloud (2000, drawLine)},
          {"EverySmallerSteps", randomCloud (2000, drawSteps)},
          {"FarFromZero", surfaces.movedBy ({1e6, -2e6, 1e6}).build().cloud},
          {"NotFinite", broken},
          {"VolumeBesideStrayPoints", beside_strays}};
}

struct Neighbors {
  pcl::Indices indices;
  std::vector<float> squared_distances;

  bool
  operator== (const Neighbors& other) const
  {
    return indices == other.indices && squared_distances == other.squared_distances;
  }
};

float
squaredDistance (const PointXYZ& first, const PointXYZ& second)
{
  const float dx = first.x - second.x, dy = first.y - second.y, dz = first.z - second.z;
  return dx * dx + dy * dy + dz * dz;
}

/** What nearestKSearch finds; it has to replace what its outputs hold before. */
Neighbors
nearest (const pcl::search::Search<PointXYZ>& search, const PointXYZ& query, int k)
{
  Neighbors found{{99, 98, 97}, {-1.0f}};
  const int number =
      search.nearestKSearch (query, k, found.indices, found.squared_distances);
  EXPECT_EQ (static_cast<std::size_t> (number), found.indices.size());
  EXPECT_EQ (static_cast<std::size_t> (number), found.squared_distances.size());
  return found;
}

constexpr unsigned no_limit = 0;

/** What radiusSearch finds; it has to replace what its outputs hold before.
 * \param[in] radius [m]
 * \param[in] max_neighbors 0: no limit */
Neighbors
within (const pcl::search::Search<PointXYZ>& search,
        const PointXYZ& query,
        double radius,
        unsigned max_neighbors = no_limit)
{
  Neighbors found{{99, 98, 97}, {-1.0f}};
  search.radiusSearch (
      query, radius, found.indices, found.squared_distances, max_neighbors);
  return found;
}

/** Neighbors within a radius, by ascending distance and then by ascending index. */
Neighbors
bruteForce (const Cloud& cloud, const PointXYZ& query, float squared_radius = INFINITY)
{
  std::vector<std::pair<float, int>> all; // squared distance, index
  for (int i = 0; i < static_cast<int> (cloud.size()); ++i)
    if (pcl::isFinite (cloud[i]) && squaredDistance (cloud[i], query) <= squared_radius)
      all.emplace_back (squaredDistance (cloud[i], query), i);
  std::sort (all.begin(), all.end());
  Neighbors found;
  for (const auto& [squared_distance, index] : all) {
    found.indices.push_back (index);
    found.squared_distances.push_back (squared_distance);
  }
  return found;
}

/** Points of the cloud, points beside them, and points far away. */
std::vector<PointXYZ>
queriesFor (const Cloud& cloud)
{
  RandomGenerator generator (seedOfTest());
  const std::size_t stride = cloud.size() / 50 + 1;
  std::vector<PointXYZ> queries{{100, 0, 0}, {0, -1e5f, 1e5f}, {1e10f, 1e10f, 1e10f}};
  for (std::size_t i = 0; i < cloud.size(); i += stride)
    for (const double away : {0_m, 1_mm, 1_m}) {
      if (!pcl::isFinite (cloud[i]))
        continue;
      PointXYZ query = cloud[i];
      query.getVector3fMap() += drawInCube (generator, away).getVector3fMap();
      queries.push_back (query);
    }
  return queries;
}

} // namespace

TEST (GridSearch, FindsWhatLookingAtAllPointsFinds)
{
  for (const auto& [name, cloud] : clouds()) {
    SCOPED_TRACE (name);
    Search search;
    search.setInputCloud (cloud);
    for (const PointXYZ& query : queriesFor (*cloud)) {
      const Neighbors all = bruteForce (*cloud, query);
      for (const std::size_t k : {1, 10, 31, 500}) {
        const Neighbors found = nearest (search, query, static_cast<int> (k));
        ASSERT_EQ (found.indices.size(), std::min (k, all.indices.size()));
        const std::set<int> different (found.indices.begin(), found.indices.end());
        EXPECT_EQ (different.size(), found.indices.size());
        for (std::size_t i = 0; i < found.indices.size(); ++i) {
          const float squared_distance = found.squared_distances[i];
          EXPECT_EQ (squared_distance, all.squared_distances[i]);
          EXPECT_EQ (squared_distance,
                     squaredDistance ((*cloud)[found.indices[i]], query));
        }
      }
      for (const double radius : {0_m, 1_mm, 10_cm, 1_m, 1e6_m})
        EXPECT_EQ (within (search, query, radius),
                   bruteForce (*cloud, query, static_cast<float> (radius * radius)));
    }
  }
}

TEST (GridSearch, GivesTheNearestOfThoseWithinTheRadius)
{
  Search search;
  search.setInputCloud (uniformVolume());
  const PointXYZ query (0.1f, 0.1f, 0.1f);
  EXPECT_EQ (within (search, query, 1_m, 20), nearest (search, query, 20));
  EXPECT_EQ (within (search, query, 5_cm, 1000000), within (search, query, 5_cm));
}

TEST (GridSearch, TakesTheLowestIndexOfEquallyNearPointsWhereverTheyAre)
{
  for (const float side : {-1.0f, 1.0f}) {
    // The first and the last point are 1 m from the query, on opposite sides of it; all
    // others are farther.
    const auto cloud = randomCloud (300, [&] (auto& g) {
      const PointXYZ drawn = drawInCube (g, 1_m);
      return PointXYZ (drawn.x + (drawn.x < 0.0f ? -1.1f : 1.1f), drawn.y, drawn.z);
    });
    cloud->front() = {side, 0, 0};
    cloud->back() = {-side, 0, 0};
    Search search;
    search.setInputCloud (cloud);
    EXPECT_EQ (nearest (search, {0, 0, 0}, 1).indices, pcl::Indices{0}) << side;
  }
}

TEST (GridSearch, UnsortedGivesTheSameNeighbors)
{
  constexpr bool is_sorted = true;
  Search sorted (is_sorted), unsorted (is_sorted);
  unsorted.setSortedResults (false);
  const auto cloud = uniformVolume();
  sorted.setInputCloud (cloud);
  unsorted.setInputCloud (cloud);
  pcl::Indices indices = nearest (sorted, {0, 0, 0}, 200).indices;
  pcl::Indices others = nearest (unsorted, {0, 0, 0}, 200).indices;
  EXPECT_NE (indices, others);
  EXPECT_TRUE (std::is_permutation (indices.begin(), indices.end(), others.begin()));
}

TEST (GridSearch, SearchesTheGivenIndicesAndTheLastCloudAlone)
{
  const auto cloud = uniformVolume();
  const auto indices = pcl::make_shared<pcl::Indices> (pcl::Indices{70, 7, 700, 7});
  Search search;
  search.setInputCloud (cloud, indices);
  pcl::Indices found = nearest (search, (*cloud)[1], 10).indices;
  std::sort (found.begin(), found.end());
  EXPECT_EQ (found, (pcl::Indices{7, 70, 700}));
  EXPECT_EQ (search.getIndices(), indices);
  std::vector<float> squared_distances;
  search.nearestKSearch (1, 1, found, squared_distances);
  EXPECT_EQ (found, pcl::Indices{7}) << "nearest to the second of them";
  search.setInputCloud (onePoint());
  EXPECT_EQ (nearest (search, {0, 0, 0}, 5).indices, pcl::Indices{0}) << "alone";
}

TEST (GridSearch, FindsNothingWhereThereIsNothing)
{
  Search search;
  const PointXYZ query (0, 0, 0);
  EXPECT_TRUE (nearest (search, query, 5).indices.empty()) << "without a cloud";
  search.setInputCloud (pcl::make_shared<Cloud>());
  EXPECT_TRUE (nearest (search, query, 5).indices.empty()) << "in an empty cloud";
  search.setInputCloud (onePoint());
  EXPECT_TRUE (nearest (search, query, 0).indices.empty()) << "of no neighbors";
  EXPECT_TRUE (within (search, query, 1_m).indices.empty()) << "within a meter";
  EXPECT_TRUE (within (search, query, -9_m).indices.empty()) << "below zero";
  EXPECT_TRUE (nearest (search, {NAN, 0, 0}, 5).indices.empty()) << "of no position";
}

TEST (NearestCandidates, StopTakingWhatIsFartherOrAsFarWithHigherIndices)
{
  NearestCandidates candidates (1, INFINITY);
  EXPECT_TRUE (candidates.mayTake (NearestCandidates::bitsOf (5.0f), 0));
  const std::vector<float> squared_distances (50, 1.0f);
  const pcl::Indices indices (50, 7);
  candidates.add (squared_distances.data(), indices.data(), indices.size());
  EXPECT_FALSE (candidates.mayTake (NearestCandidates::bitsOf (5.0f), 0));
  EXPECT_FALSE (candidates.mayTake (NearestCandidates::bitsOf (1.0f), 8));
  EXPECT_TRUE (candidates.mayTake (NearestCandidates::bitsOf (1.0f), 6));
}
