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

/** A cloud of points that \p draw returns. */
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

/** 3000 points drawn uniformly in a cube of 1 m centered at zero. */
Cloud::Ptr
uniformVolume ()
{
  return randomCloud (3000,
                      [] (auto& generator) { return drawInCube (generator, 1_m); });
}

Cloud::Ptr
onePoint ()
{
  return randomCloud (1, [] (auto&) { return PointXYZ (1, 2, 3); });
}

/** \ref uniformVolume in which more than half of the points are not finite. */
Cloud::Ptr
volumeWithoutHalfOfItsPoints ()
{
  Cloud::Ptr cloud = uniformVolume();
  for (std::size_t i = 0; i < cloud->size(); i += 2)
    (*cloud)[i].y = NAN;
  (*cloud)[1].z = INFINITY;
  return cloud;
}

Cloud::Ptr
volumeBesideStrayPoints ()
{
  Cloud::Ptr cloud = uniformVolume();
  cloud->push_back ({1e7f, 0, 0});
  cloud->push_back ({-1e12f, 1e12f, 0});
  return cloud;
}

/** Clouds by name, most of which are hard to search. */
std::map<std::string, Cloud::Ptr>
clouds ()
{
  const auto drawDenseOrSparse = [] (auto& generator) {
    return drawInCube (generator, drawUnit (generator) < 0.9 ? 1_mm : 1000_m);
  };
  const auto drawOneOfSeven = [] (auto& generator) {
    const auto i = static_cast<float> (drawBelow (generator, 7));
    return PointXYZ (i, 2.0f * i, -i);
  };
  const auto drawOnLine = [] (auto& generator) {
    const auto t = static_cast<float> (drawUnit (generator));
    return PointXYZ (t, 2.0f * t, 3.0f * t);
  };
  // In a cube whose edge is drawn from 1e-9 m to 1e3 m, uniformly in its logarithm: the
  // density grows towards zero.
  const auto drawDenserTowardsZero = [] (auto& generator) {
    return drawInCube (generator, std::pow (10.0, 12.0 * drawUnit (generator) - 9.0));
  };
  const auto drawEqual = [] (auto&) { return PointXYZ (1, 2, 3); };
  Scene surfaces = room().spacing (10_cm);
  return {{"UniformVolume", uniformVolume()},
          {"Surfaces", surfaces.build().cloud},
          {"OnePoint", onePoint()},
          {"DenseClusterAmongSparsePoints", randomCloud (4000, drawDenseOrSparse)},
          {"Duplicates", randomCloud (2000, drawOneOfSeven)},
          {"AllEqual", randomCloud (1000, drawEqual)},
          {"Line", randomCloud (2000, drawOnLine)},
          {"DenserTowardsZero", randomCloud (2000, drawDenserTowardsZero)},
          {"FarFromZero", surfaces.movedBy ({1e6, -2e6, 1e6}).build().cloud},
          {"HalfNotFinite", volumeWithoutHalfOfItsPoints()},
          {"VolumeBesideStrayPoints", volumeBesideStrayPoints()}};
}

/** The result of a search: neighbor i has indices[i] and squared_distances[i] [m^2]. */
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

const Neighbors to_be_overwritten{{99, 98, 97}, {-1.0f}};

/** The k nearest neighbors by nearestKSearch, which has to overwrite its outputs. */
Neighbors
nearest (const pcl::search::Search<PointXYZ>& search, const PointXYZ& query, int k)
{
  Neighbors found = to_be_overwritten;
  const int number =
      search.nearestKSearch (query, k, found.indices, found.squared_distances);
  EXPECT_EQ (static_cast<std::size_t> (number), found.indices.size());
  EXPECT_EQ (static_cast<std::size_t> (number), found.squared_distances.size());
  return found;
}

constexpr unsigned no_limit = 0;

/** The neighbors within a radius by radiusSearch, which has to overwrite its outputs.
 * \param[in] radius [m]
 * \param[in] max_neighbors 0: no limit */
Neighbors
within (const pcl::search::Search<PointXYZ>& search,
        const PointXYZ& query,
        double radius,
        unsigned max_neighbors = no_limit)
{
  Neighbors found = to_be_overwritten;
  search.radiusSearch (
      query, radius, found.indices, found.squared_distances, max_neighbors);
  return found;
}

/** The finite points within a radius of the query, from a loop over all points: by
 * ascending distance, those at equal distances by ascending index. */
Neighbors
neighborsByBruteForce (const Cloud& cloud,
                       const PointXYZ& query,
                       float squared_radius = INFINITY)
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

/** Some 50 points of the cloud, points up to 1 m beside these, and points far away. */
std::vector<PointXYZ>
queriesFor (const Cloud& cloud)
{
  RandomGenerator generator (seedOfTest());
  const std::size_t stride = cloud.size() / 50 + 1;
  std::vector<PointXYZ> queries{{100, 0, 0}, {0, -1e5f, 1e5f}, {1e10f, 1e10f, 1e10f}};
  for (std::size_t i = 0; i < cloud.size(); i += stride)
    for (const double edge_of_cube : {0_m, 1_mm, 1_m}) {
      if (!pcl::isFinite (cloud[i]))
        continue;
      PointXYZ query = cloud[i];
      query.getVector3fMap() += drawInCube (generator, edge_of_cube).getVector3fMap();
      queries.push_back (query);
    }
  return queries;
}

} // namespace

TEST (GridSearch, FindsTheNeighborsThatBruteForceFinds)
{
  for (const auto& [name, cloud] : clouds()) {
    SCOPED_TRACE (name);
    Search search;
    search.setInputCloud (cloud);
    for (const PointXYZ& query : queriesFor (*cloud)) {
      const Neighbors all = neighborsByBruteForce (*cloud, query);
      for (const std::size_t k : {1, 10, 31, 500}) {
        const Neighbors found = nearest (search, query, static_cast<int> (k));
        ASSERT_EQ (found.indices.size(), std::min (k, all.indices.size()));
        const std::set<int> distinct (found.indices.begin(), found.indices.end());
        EXPECT_EQ (distinct.size(), found.indices.size());
        for (std::size_t i = 0; i < found.indices.size(); ++i) {
          const float squared_distance = found.squared_distances[i];
          EXPECT_EQ (squared_distance, all.squared_distances[i]);
          EXPECT_EQ (squared_distance,
                     squaredDistance ((*cloud)[found.indices[i]], query));
        }
      }
      for (const double radius : {0_m, 1_mm, 10_cm, 1_m, 1e6_m})
        EXPECT_EQ (within (search, query, radius),
                   neighborsByBruteForce (
                       *cloud, query, static_cast<float> (radius * radius)));
    }
  }
}

TEST (GridSearch, GivesTheNearestOfTheNeighborsWithinTheRadiusIfThereIsALimit)
{
  Search search;
  search.setInputCloud (uniformVolume());
  const PointXYZ query (0.1f, 0.1f, 0.1f);
  EXPECT_EQ (within (search, query, 1_m, 20), nearest (search, query, 20));
  constexpr unsigned more_than_all = 1000000;
  EXPECT_EQ (within (search, query, 5_cm, more_than_all), within (search, query, 5_cm));
}

TEST (GridSearch, TakesTheLowestIndexOfEquallyNearPointsOnEitherSideOfTheQuery)
{
  for (const float side : {-1.0f, 1.0f}) {
    // The first and the last point are 1 m from the query, on opposite sides of it; all
    // others are farther.
    const Cloud::Ptr cloud = randomCloud (300, [] (auto& generator) {
      const PointXYZ drawn = drawInCube (generator, 1_m);
      return PointXYZ (drawn.x + (drawn.x < 0.0f ? -1.1f : 1.1f), drawn.y, drawn.z);
    });
    cloud->front() = {side, 0, 0};
    cloud->back() = {-side, 0, 0};
    Search search;
    search.setInputCloud (cloud);
    EXPECT_EQ (nearest (search, {0, 0, 0}, 1).indices, pcl::Indices{0}) << side;
  }
}

TEST (GridSearch, GivesTheSameNeighborsInAnotherOrderIfResultsNeedNotBeSorted)
{
  constexpr bool is_sorted = true;
  Search sorted (is_sorted), unsorted (is_sorted);
  unsorted.setSortedResults (false);
  const Cloud::Ptr cloud = uniformVolume();
  sorted.setInputCloud (cloud);
  unsorted.setInputCloud (cloud);
  const pcl::Indices by_distance = nearest (sorted, {0, 0, 0}, 200).indices;
  const pcl::Indices in_any_order = nearest (unsorted, {0, 0, 0}, 200).indices;
  EXPECT_NE (by_distance, in_any_order);
  EXPECT_TRUE (std::is_permutation (
      by_distance.begin(), by_distance.end(), in_any_order.begin()));
}

TEST (GridSearch, SearchesOnlyTheGivenIndicesAndTheCloudThatWasSetLast)
{
  const Cloud::Ptr cloud = uniformVolume();
  const auto indices = pcl::make_shared<pcl::Indices> (pcl::Indices{70, 7, 700, 7});
  Search search;
  search.setInputCloud (cloud, indices);
  pcl::Indices found = nearest (search, (*cloud)[1], 10).indices;
  std::sort (found.begin(), found.end());
  EXPECT_EQ (found, (pcl::Indices{7, 70, 700}));
  EXPECT_EQ (search.getIndices(), indices);
  std::vector<float> squared_distances;
  constexpr pcl::index_t second_of_indices = 1; // point 7
  search.nearestKSearch (second_of_indices, 1, found, squared_distances);
  EXPECT_EQ (found, pcl::Indices{7});
  search.setInputCloud (onePoint());
  EXPECT_EQ (nearest (search, {0, 0, 0}, 5).indices, pcl::Indices{0});
}

TEST (GridSearch, FindsNothingInNoPointsOrForAQueryThatHasNoNeighbors)
{
  Search search;
  const PointXYZ query (0, 0, 0);
  EXPECT_TRUE (nearest (search, query, 5).indices.empty()) << "without a cloud";
  search.setInputCloud (pcl::make_shared<Cloud>());
  EXPECT_TRUE (nearest (search, query, 5).indices.empty()) << "in an empty cloud";
  search.setInputCloud (onePoint());
  EXPECT_TRUE (nearest (search, query, 0).indices.empty()) << "k is 0";
  EXPECT_TRUE (within (search, query, 1_m).indices.empty())
      << "the point is 3.7 m away";
  EXPECT_TRUE (within (search, query, -9_m).indices.empty()) << "a radius below zero";
  EXPECT_TRUE (nearest (search, {NAN, 0, 0}, 5).indices.empty())
      << "a query that is not finite";
}

TEST (NearestCandidates, TakeNoPointThatIsFartherOrAsFarWithAHigherIndex)
{
  constexpr std::size_t wanted = 1;
  NearestCandidates candidates (wanted, INFINITY);
  const std::uint32_t far = NearestCandidates::bitsOf (5.0f);
  EXPECT_TRUE (candidates.mayTake (far, 0));
  // So many that all but the nearest are dropped.
  constexpr pcl::index_t index = 7;
  constexpr float squared_distance = 1.0f;
  const std::vector<float> squared_distances (50, squared_distance);
  const pcl::Indices indices (50, index);
  candidates.add (squared_distances.data(), indices.data(), indices.size());
  EXPECT_FALSE (candidates.mayTake (far, 0));
  const std::uint32_t as_far = NearestCandidates::bitsOf (squared_distance);
  EXPECT_FALSE (candidates.mayTake (as_far, index + 1));
  EXPECT_TRUE (candidates.mayTake (as_far, index - 1));
}
