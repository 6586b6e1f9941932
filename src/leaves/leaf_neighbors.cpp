// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "leaves/leaf_neighbors.h"

#include "base/parallel.h"

#include <array>
#include <cstdint>
#include <utility>

namespace pcl_ops::internal {

namespace {

constexpr int no_leaf = -1;

/** \brief A node of the octree above the leaves; chains of single children are left
 * out. */
struct Node {
  std::uint32_t x, y, z; // its lowest corner [finest cells]
  int level;
  int leaf; // or no_leaf, where it has children
  int children = 0;
  std::array<std::uint32_t, 8> child = {};

  std::uint32_t
  edge () const
  {
    return std::uint32_t{1} << level;
  }
};

bool
touch (const Node& a, const Node& b)
{
  return a.x <= b.x + b.edge() && b.x <= a.x + a.edge() && a.y <= b.y + b.edge() &&
         b.y <= a.y + a.edge() && a.z <= b.z + b.edge() && b.z <= a.z + a.edge();
}

/** \brief The octree above some leaves, the parent before its children. */
struct Tree {
  const std::vector<Leaf>& leaves;
  std::vector<Node> nodes = {};

  bool
  areInOneCell (std::uint32_t first, std::uint32_t last, int level) const
  {
    return leaves[first].code >> 3 * level == leaves[last].code >> 3 * level;
  }

  std::uint32_t
  build (std::uint32_t begin, std::uint32_t end, int level)
  {
    const bool is_leaf = end - begin == 1;
    while (!is_leaf && areInOneCell (begin, end - 1, level - 1))
      --level;
    if (is_leaf)
      level = leaves[begin].level;
    const MortonCode corner = leaves[begin].code >> 3 * level << 3 * level;
    const auto node = static_cast<std::uint32_t> (nodes.size());
    nodes.push_back ({gatherBits (corner),
                      gatherBits (corner >> 1),
                      gatherBits (corner >> 2),
                      level,
                      is_leaf ? static_cast<int> (begin) : no_leaf});
    for (std::uint32_t i = begin; !is_leaf && i < end;) {
      std::uint32_t next = i + 1;
      while (next < end && areInOneCell (i, next, level - 1))
        ++next;
      const std::uint32_t child = build (i, next, level - 1);
      nodes[node].child[nodes[node].children++] = child;
      i = next;
    }
    return node;
  }
};

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/** \brief Each pair of leaves that touch, once. */
struct TouchingPairs {
  const std::vector<Node>& nodes;
  Pairs pairs = {};

  void
  addWithin (const Node& node)
  {
    for (int i = 0; i < node.children; ++i) {
      const Node& child = nodes[node.child[i]];
      addWithin (child);
      for (int k = i + 1; k < node.children; ++k)
        addBetween (child, nodes[node.child[k]]);
    }
  }

  void
  addBetween (const Node& a, const Node& b)
  {
    if (!touch (a, b))
      return;
    if (a.leaf != no_leaf && b.leaf != no_leaf) {
      pairs.emplace_back (a.leaf, b.leaf);
      return;
    }
    const bool goes_down_a =
        a.leaf == no_leaf && (b.leaf != no_leaf || a.level >= b.level);
    const Node& larger = goes_down_a ? a : b;
    const Node& other = goes_down_a ? b : a;
    for (int k = 0; k < larger.children; ++k)
      addBetween (nodes[larger.child[k]], other);
  }
};

/** \brief A node whose leaves are to be paired, or two nodes. */
struct Pairing {
  std::uint32_t node, other; // equal: within the node
};

// Pairings that have each pair of leaves once, in the order of \ref TouchingPairs.
void
addPairings (const std::vector<Node>& nodes,
             std::uint32_t number,
             std::vector<Pairing>& pairings)
{
  // Nodes of this level hold some 200 leaves.
  constexpr int level_at_once = 10;
  const Node& node = nodes[number];
  if (node.level <= level_at_once) {
    pairings.push_back ({number, number});
    return;
  }
  for (int i = 0; i < node.children; ++i) {
    addPairings (nodes, node.child[i], pairings);
    for (int k = i + 1; k < node.children; ++k)
      if (touch (nodes[node.child[i]], nodes[node.child[k]]))
        pairings.push_back ({node.child[i], node.child[k]});
  }
}

// Each pair of leaves that touch, once.
std::vector<Pairs>
touchingPairs (const std::vector<Node>& nodes, unsigned threads)
{
  std::vector<Pairing> pairings;
  addPairings (nodes, 0, pairings);
  constexpr std::size_t at_once = 4;
  return parallelChunks (
      threads, pairings.size(), at_once, [&] (std::size_t begin, std::size_t end) {
        TouchingPairs touching{nodes};
        for (std::size_t p = begin; p < end; ++p) {
          const auto& [node, other] = pairings[p];
          if (node == other)
            touching.addWithin (nodes[node]);
          else
            touching.addBetween (nodes[node], nodes[other]);
        }
        return std::move (touching.pairs);
      });
}

} // namespace

LeafNeighbors
connectLeaves (const std::vector<Leaf>& leaves, unsigned threads)
{
  LeafNeighbors graph;
  if (leaves.empty())
    return graph;
  const auto number = static_cast<std::uint32_t> (leaves.size());
  Tree tree{leaves};
  tree.nodes.reserve (2 * leaves.size());
  tree.build (0, number, top_level);
  const std::vector<Pairs> touching = touchingPairs (tree.nodes, threads);
  // Counted, then placed: each leaf first, as a neighbor of its own.
  Indices next (leaves.size() + 1, 0);
  for (const Pairs& pairs : touching)
    for (const auto& [first, second] : pairs) {
      ++next[first + 1];
      ++next[second + 1];
    }
  for (std::uint32_t i = 0; i < number; ++i)
    next[i + 1] += next[i] + 1;
  graph.begin = next;
  graph.neighbors.resize (next.back());
  for (std::uint32_t i = 0; i < number; ++i)
    graph.neighbors[next[i]++] = i;
  for (const Pairs& pairs : touching)
    for (const auto& [first, second] : pairs) {
      graph.neighbors[next[first]++] = second;
      graph.neighbors[next[second]++] = first;
    }
  return graph;
}

} // namespace pcl_ops::internal
