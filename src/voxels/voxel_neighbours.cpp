// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxels/voxel_neighbours.h"

#include "base/parallel.h"

#include <array>

namespace pcl_ops::internal {

namespace {

constexpr std::size_t parents_per_piece = 256;
constexpr std::int32_t no_voxel = -1;

/** \brief The 3 x 3 x 3 voxels around one, x fastest; no_voxel where none is occupied.
 */
using Surroundings = std::array<std::int32_t, 27>;

/** \brief The 2 x 2 x 2 children of a voxel and those one around them: 4 x 4 x 4, x
 * fastest; then one place for all that are farther away. */
using ChildrenAround = std::array<std::int32_t, 65>;

// Where a child is among \ref ChildrenAround, by its octant and by where its parent is
// in the \ref Surroundings.
constexpr std::array<std::array<std::uint8_t, 8>, 27>
placesOfChildren ()
{
  constexpr std::uint8_t far_away = 64;
  std::array<std::array<std::uint8_t, 8>, 27> places{};
  for (int parent = 0; parent < 27; ++parent)
    for (int octant = 0; octant < 8; ++octant) {
      const int x = parent % 3 * 2 + (octant & 1) - 1;
      const int y = parent / 3 % 3 * 2 + (octant >> 1 & 1) - 1;
      const int z = parent / 9 * 2 + (octant >> 2) - 1;
      const bool is_near = x >= 0 && x < 4 && y >= 0 && y < 4 && z >= 0 && z < 4;
      places[static_cast<std::size_t> (parent)][static_cast<std::size_t> (octant)] =
          is_near ? static_cast<std::uint8_t> ((z * 4 + y) * 4 + x) : far_away;
    }
  return places;
}

// The first of the 3 x 3 x 3 around each child.
constexpr std::array<std::uint8_t, 8> first_around{0, 1, 4, 5, 16, 17, 20, 21};

/** \brief Voxels of twice the edge with where the children of each begin. */
struct Parents {
  std::vector<MortonCode> codes;
  std::vector<std::uint32_t> first_child;
};

Parents
parentsOf (const std::vector<MortonCode>& codes)
{
  Parents parents;
  for (std::size_t i = 0; i < codes.size(); ++i)
    if (parents.codes.empty() || parents.codes.back() != codes[i] >> 3) {
      parents.codes.push_back (codes[i] >> 3);
      parents.first_child.push_back (static_cast<std::uint32_t> (i));
    }
  parents.first_child.push_back (static_cast<std::uint32_t> (codes.size()));
  return parents;
}

// Calls visit (voxel, around) for the children of a range of parents; around: the first
// of the 3 x 3 x 3 children around it in rows of 4.
template <typename Visit>
void
forChildren (const std::vector<MortonCode>& codes,
             const Parents& parents,
             const std::vector<Surroundings>& around_parents,
             std::size_t begin,
             std::size_t end,
             Visit&& visit)
{
  static constexpr auto places = placesOfChildren();
  ChildrenAround children;
  for (std::size_t p = begin; p < end; ++p) {
    children.fill (no_voxel);
    for (std::size_t i = 0; i < around_parents[p].size(); ++i) {
      const std::int32_t parent = around_parents[p][i];
      if (parent == no_voxel)
        continue;
      const std::uint32_t* const first =
          &parents.first_child[static_cast<std::size_t> (parent)];
      for (std::uint32_t child = first[0]; child < first[1]; ++child)
        children[places[i][codes[child] & 7]] = static_cast<std::int32_t> (child);
    }
    for (std::uint32_t child = parents.first_child[p];
         child < parents.first_child[p + 1];
         ++child)
      visit (child, &children[first_around[codes[child] & 7]]);
  }
}

// Calls visit (voxel) for the 3 x 3 x 3 voxels in rows of 4.
template <typename Visit>
void
forSurroundings (const std::int32_t* around, Visit&& visit)
{
  for (int z = 0; z < 3; ++z)
    for (int y = 0; y < 3; ++y)
      for (int x = 0; x < 3; ++x)
        visit (around[(z * 4 + y) * 4 + x]);
}

std::vector<Surroundings>
surroundingsOf (const std::vector<MortonCode>& codes, unsigned threads)
{
  std::vector<Surroundings> surroundings (codes.size());
  if (codes.size() == 1) {
    surroundings[0].fill (no_voxel);
    surroundings[0][13] = 0;
    return surroundings;
  }
  const Parents parents = parentsOf (codes);
  const std::vector<Surroundings> around_parents =
      surroundingsOf (parents.codes, threads);
  parallelFor (
      threads, parents.codes.size(), parents_per_piece, [&] (auto begin, auto end) {
        forChildren (codes,
                     parents,
                     around_parents,
                     begin,
                     end,
                     [&surroundings] (std::size_t voxel, const std::int32_t* around) {
                       std::size_t i = 0;
                       forSurroundings (around, [&] (std::int32_t other) {
                         surroundings[voxel][i++] = other;
                       });
                     });
      });
  return surroundings;
}

// Appends a voxel with the occupied ones of its surroundings.
void
add (const std::int32_t* around, VoxelNeighbours& neighbours)
{
  std::array<std::uint32_t, 27> found;
  std::size_t number = 0;
  forSurroundings (around, [&] (std::int32_t voxel) {
    // Written always, counted if there: no branch to mispredict.
    found[number] = static_cast<std::uint32_t> (voxel);
    number += voxel != no_voxel;
  });
  neighbours.add (found.data(), number);
}

} // namespace

void
VoxelNeighbours::append (const VoxelNeighbours& other)
{
  const auto before = static_cast<std::uint32_t> (neighbours_.size());
  neighbours_.insert (
      neighbours_.end(), other.neighbours_.begin(), other.neighbours_.end());
  for (std::size_t i = 1; i < other.begin_.size(); ++i)
    begin_.push_back (before + other.begin_[i]);
}

VoxelNeighbours
neighboursOf (const std::vector<MortonCode>& codes, unsigned threads)
{
  VoxelNeighbours neighbours;
  if (codes.empty())
    return neighbours;
  const Parents parents = parentsOf (codes);
  const std::vector<Surroundings> around_parents =
      surroundingsOf (parents.codes, threads);
  const auto pieces = parallelPieces (
      threads, parents.codes.size(), parents_per_piece, [&] (auto begin, auto end) {
        VoxelNeighbours piece;
        forChildren (codes,
                     parents,
                     around_parents,
                     begin,
                     end,
                     [&piece] (std::size_t, const std::int32_t* around) {
                       add (around, piece);
                     });
        return piece;
      });
  for (const VoxelNeighbours& piece : pieces)
    neighbours.append (piece);
  return neighbours;
}

} // namespace pcl_ops::internal
