// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/point_tree.h"
#include "scene.h"

#include <algorithm>
#include <tuple>

using namespace pcl_ops::internal;

namespace {

/** \brief So many points, drawn uniformly in a cube of 1 m. */
Coordinates
drawnPoints (std::size_t number)
{
  Coordinates points;
  RandomGenerator generator (seedOfTest());
  for (std::size_t i = 0; i < number; ++i) {
    const auto draw = [&] { return static_cast<float> (drawUnit (generator)); };
    const float x = draw();
    const float y = draw();
    points.add (x, y, draw());
  }
  return points;
}

/** \brief A point as a candidate for a nearest point. */
struct Candidate {
  float squared_distance; // [m^2]
  std::uint32_t index;
};

/** \brief Indices of the points nearest to a point, itself included, by distance, then
 * by index; fewer than wanted if there are not so many.
 * \param[in] query index of the point */
std::vector<std::uint32_t>
nearestByBruteForce (const Coordinates& points, std::uint32_t query, std::size_t wanted)
{
  std::vector<Candidate> all;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const float x = points.x[i] - points.x[query];
    const float y = points.y[i] - points.y[query];
    const float z = points.z[i] - points.z[query];
    all.push_back ({x * x + y * y + z * z, i});
  }
  std::sort (all.begin(), all.end(), [] (const Candidate& a, const Candidate& b) {
    return std::tie (a.squared_distance, a.index) <
           std::tie (b.squared_distance, b.index);
  });
  std::vector<std::uint32_t> nearest;
  for (std::size_t i = 0; i < std::min (wanted, all.size()); ++i)
    nearest.push_back (all[i].index);
  return nearest;
}

/** \brief The same points as \ref nearestByBruteForce, found by the tree.
 * \param[in] position of the point in PointTree::order */
std::vector<std::uint32_t>
nearestOf (const PointTree& tree, std::size_t position, std::size_t wanted)
{
  NearestPoints found;
  found.start (wanted);
  tree.find (position, found);
  std::vector<std::uint32_t> nearest;
  for (std::size_t i = 0; i < found.size(); ++i)
    nearest.push_back (found[i]);
  return nearest;
}

} // namespace

TEST (PointTree, FindsWhatBruteForceFinds)
{
  const Coordinates points = drawnPoints (500);
  const PointTree tree (points);
  for (std::size_t position = 0; position < points.size(); ++position)
    ASSERT_EQ (nearestOf (tree, position, 20),
               nearestByBruteForce (points, tree.order()[position], 20));
}

TEST (PointTree, TakesThoseOfLowestIndexAmongEquallyNearPoints)
{
  Coordinates grid;
  for (int x = 0; x < 12; ++x)
    for (int y = 0; y < 12; ++y)
      grid.add (static_cast<float> (x), static_cast<float> (y), 0.0f);
  const PointTree tree (grid);
  for (std::size_t position = 0; position < grid.size(); ++position)
    ASSERT_EQ (nearestOf (tree, position, 7),
               nearestByBruteForce (grid, tree.order()[position], 7));
}

TEST (PointTree, HasEachPointOnce)
{
  const PointTree tree (drawnPoints (1000));
  Indices order = tree.order();
  std::sort (order.begin(), order.end());
  EXPECT_EQ (order, upTo (1000));
}

TEST (PointTree, FindsFewerWhereThereAreFewer)
{
  EXPECT_EQ (nearestOf (PointTree (drawnPoints (5)), 2, 20).size(), 5u);
}
