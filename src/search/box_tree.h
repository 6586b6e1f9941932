// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/types.h>

#include <Eigen/Core>

#include <pcl_ops/points.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace pcl_ops {

class NearestCandidates;

/** \brief The positions in a cloud of any point type, each three floats side by side.
 */
struct CloudPositions {
  /** \brief x of the first point. */
  const float* first = nullptr;
  /** \brief From each point to the next. */
  std::size_t floats_per_point = 0;

  const float*
  operator[] (pcl::index_t i) const
  {
    return first + static_cast<std::size_t> (i) * floats_per_point;
  }
};

/** \brief Which neighbours are asked for. */
struct NeighbourQuery {
  Eigen::Vector3f position = Eigen::Vector3f::Zero();
  /** \brief k: most neighbours, the nearest ones. */
  std::size_t most = std::numeric_limits<std::size_t>::max();
  /** \brief Largest squared distance of a neighbour [m^2]. */
  float squared_radius = std::numeric_limits<float>::infinity();
  /** \brief Whether neighbours come by rising distance, equal ones by rising index. */
  bool sorted = true;
};

/** \brief Exact neighbours of any position: points sorted into the cells of a uniform
 * grid, and a tree of boxes over the cells.
 *
 * The sort takes a pass over the points, the tree is built on the cells alone: together
 * a fraction of the time of a kd-tree that sorts points at every level. Cells with many
 * points are split further, so that clouds of any density are searched in logarithmic
 * time. Once built it never changes: any number of threads may search it. */
class CellTree {
public:
  CellTree() = default;

  /** \param[in] points finite points in their local frame
   * \param[in] cloud where they come from: queries and distances are in its frame, so
   * that no rounding to another changes distances; not needed afterwards */
  CellTree (const Points& points, const CloudPositions& cloud);

  /** \brief Number of points. */
  std::size_t
  size () const
  {
    return index_.size();
  }

  /** \brief Finds the nearest points within the radius. Which of several at the same
   * distance as the farthest one are found depends on the points and the query alone.
   * \param[in] query its position is finite
   * \param[out] indices of the neighbours; what it held is replaced
   * \param[out] squared_distances in single precision, as PCL computes them [m^2] */
  void
  find (const NeighbourQuery& query,
        pcl::Indices& indices,
        std::vector<float>& squared_distances) const;

private:
  static constexpr std::size_t most_children = 8;
  using OfChildren = std::array<float, most_children>;

  /** \brief Where the points of a child are. */
  struct Child {
    /** \brief Position of a leaf's first point, or number of a node. */
    std::uint32_t first = 0;
    /** \brief Number of a leaf's points; 0: a node. */
    std::uint32_t size = 0;
  };

  /** \brief The bounding boxes of all children side by side: one loop tests them. */
  struct Node {
    OfChildren low_x, low_y, low_z, high_x, high_y, high_z;
    std::array<Child, most_children> children;
    std::uint32_t number = 0;
  };

  /** \brief Something with a position that a node holds: a cell or a point. */
  struct Item {
    std::array<float, 3> position;
    std::uint32_t id;
    std::uint32_t points;
  };

  /** \brief Items of a child. */
  struct ItemRange {
    Item* begin;
    Item* end;
    std::uint32_t points;
  };

  void
  sortIntoCells (const Points& points, const CloudPositions& cloud);
  /** \brief Adds a node over items, and others below it until leaves have few points or
   * one item.
   * \param[in,out] items reordered leaf after leaf
   * \param[in] first_point of the node
   * \return its number */
  std::uint32_t
  grow (const ItemRange& items, std::uint32_t first_point);
  static std::vector<ItemRange>
  split (const ItemRange& items);
  Child
  splitCrowded (Child leaf);
  void
  splitCrowdedLeaves ();
  void
  computeBoxes ();
  void
  computeBox (Node& node, std::uint32_t child) const;
  static void
  squaredDistances (const Node& node,
                    const Eigen::Vector3f& position,
                    OfChildren& distances);
  void
  visit (const Eigen::Vector3f& position, NearestCandidates& candidates) const;
  void
  visitLeaf (const Child& leaf,
             const Eigen::Vector3f& position,
             NearestCandidates& candidates) const;

  /** \brief The root first, each before those below it. */
  std::vector<Node> nodes_;
  /** \brief Points leaf after leaf. */
  Coordinates points_;
  pcl::Indices index_;
};

} // namespace pcl_ops
