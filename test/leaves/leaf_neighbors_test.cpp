// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "leaf_scene.h"

#include <set>

using namespace pcl_ops::internal;

namespace {

Leaf
leafAtCell (int x, int y, int z, int level)
{
  Leaf leaf;
  leaf.code = mortonCode (x, y, z);
  leaf.level = level;
  return leaf;
}

bool
touchAlong (MortonCode a, int level_of_a, MortonCode b, int level_of_b)
{
  const auto begin_a = static_cast<long> (gatherBits (a));
  const auto begin_b = static_cast<long> (gatherBits (b));
  return begin_a <= begin_b + (1L << level_of_b) &&
         begin_b <= begin_a + (1L << level_of_a);
}

/** \brief All pairs of leaves asked one by one. */
std::set<std::uint32_t>
touchingOneByOne (const std::vector<Leaf>& leaves, std::size_t own)
{
  std::set<std::uint32_t> touching;
  for (std::uint32_t other = 0; other < leaves.size(); ++other) {
    bool touch = true;
    for (const int axis : {0, 1, 2})
      touch = touch && touchAlong (leaves[own].code >> axis,
                                   leaves[own].level,
                                   leaves[other].code >> axis,
                                   leaves[other].level);
    if (touch)
      touching.insert (other);
  }
  return touching;
}

} // namespace

TEST (LeafNeighbors, AreThoseThatTouchOfAnySize)
{
  // Dense in a corner: leaves of 5 to 40 cm.
  Coordinates points = pointsInACube (1000, 3.0);
  const Coordinates dense = pointsInACube (1000, 0.6);
  for (std::size_t i = 0; i < dense.size(); ++i)
    points.add (dense.x[i], dense.y[i], dense.z[i]);
  const LeafScene scene (points, 1_mm, {4, 1, 6.0});
  const std::vector<Leaf>& leaves = scene.cloud.leaves;
  std::set<int> levels;
  for (std::size_t leaf = 0; leaf < leaves.size(); ++leaf) {
    const IndexRange range = scene.cloud.neighbors[leaf];
    const std::set<std::uint32_t> found (range.begin(), range.end());
    ASSERT_EQ (found, touchingOneByOne (leaves, leaf));
    EXPECT_EQ (found.size(), range.size()) << "each once";
    levels.insert (leaves[leaf].level);
  }
  EXPECT_GE (levels.size(), 3u);
}

TEST (LeafNeighbors, BeginWithTheLeafItself)
{
  const LeafScene scene ({ground, wall});
  for (std::uint32_t leaf = 0; leaf < scene.cloud.size(); ++leaf)
    EXPECT_EQ (*scene.cloud.neighbors[leaf].begin(), leaf);
}

TEST (LeafNeighbors, MayTouchInACorner)
{
  const LeafNeighbors touching = connectLeaves (
      {leafAtCell (0, 0, 0, 2), leafAtCell (4, 4, 4, 0), leafAtCell (8, 8, 8, 1)}, 1);
  EXPECT_EQ (touching[0].size(), 2u);
  EXPECT_EQ (touching[1].size(), 2u);
  EXPECT_EQ (touching[2].size(), 1u) << "three cells away";
}

TEST (LeafNeighbors, AreTheSameForAnyNumberOfThreads)
{
  // A ground of finest cells across a corner of eight cells of level 10.
  std::vector<Leaf> leaves;
  for (int x = 1000; x < 1050; ++x)
    for (int y = 1000; y < 1050; ++y)
      leaves.push_back (leafAtCell (x, y, 1023 + x % 2, 0));
  std::sort (leaves.begin(), leaves.end(), [] (const Leaf& a, const Leaf& b) {
    return a.code < b.code;
  });
  const LeafNeighbors one = connectLeaves (leaves, 1);
  EXPECT_GT (one.neighbors.size(), 4 * leaves.size());
  for (const unsigned threads : {2u, 3u}) {
    const LeafNeighbors more = connectLeaves (leaves, threads);
    EXPECT_EQ (more.neighbors, one.neighbors);
    EXPECT_EQ (more.begin, one.begin);
  }
}

TEST (LeafNeighbors, OfALoneLeafAreItself)
{
  EXPECT_EQ (connectLeaves ({leafAtCell (3, 4, 5, 0)}, 1).neighbors, Indices{0});
  EXPECT_TRUE (connectLeaves ({}, 2).neighbors.empty());
}
