// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/point_tree.h"
#include "scene.h"

#include <algorithm>

using namespace pcl_ops::internal;

namespace {

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

/** \brief The nearest points of a point, itself included, by distance, then by index.
 */
std::vector<std::uint32_t>
nearestByBruteForce (const Coordinates& points, std::uint32_t query, std::size_t wanted)
{
  std::vector<std::pair<float, std::uint32_t>> all; // squared distance, index
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const float x = points.x[i] - points.x[query];
    const float y = points.y[i] - points.y[query];
    const float z = points.z[i] - points.z[query];
    all.emplace_back (x * x + y * y + z * z, i);
  }
  std::sort (all.begin(), all.end());
  std::vector<std::uint32_t> nearest;
  for (std::size_t i = 0; i < std::min (wanted, all.size()); ++i)
    nearest.push_back (all[i].second);
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
  for (std::size_t p = 0; p < points.size(); ++p)
    ASSERT_EQ (nearestOf (tree, p, 20),
               nearestByBruteForce (points, tree.order()[p], 20));
}

TEST (PointTree, TakesTheLowestNumbersOfEquallyNearPoints)
{
  Coordinates grid;
  for (int x = 0; x < 12; ++x)
    for (int y = 0; y < 12; ++y)
      grid.add (static_cast<float> (x), static_cast<float> (y), 0.0f);
  const PointTree tree (grid);
  for (std::size_t p = 0; p < grid.size(); ++p)
    ASSERT_EQ (nearestOf (tree, p, 7), nearestByBruteForce (grid, tree.order()[p], 7));
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
