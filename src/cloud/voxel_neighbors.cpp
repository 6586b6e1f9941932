// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/voxel_neighbors.h"

#include "base/parallel.h"

#include <algorithm>
#include <array>
#include <memory>
#include <numeric>
#include <utility>

namespace pcl_ops::internal {

namespace {

using Indices = std::vector<std::uint32_t>;

constexpr std::size_t parents_per_piece = 256; // chosen by hand, changes only the time

// Bit sets of 3 x 3 x 3 blocks of voxels, as VoxelNeighbors::occupied: bit x + 4 y +
// 16 z. They are spaced as in 4 x 4 x 4 cells, so that a shift moves a block there: see
// writeNeighbors.
constexpr std::uint64_t row_of_block = 0x7;
constexpr std::uint64_t layer_of_block =
    row_of_block | row_of_block << 4 | row_of_block << 8;
constexpr std::uint64_t whole_block =
    layer_of_block | layer_of_block << 16 | layer_of_block << 32;
constexpr std::uint64_t middle_of_block = 1 << 21; // (1, 1, 1)
constexpr int bits_of_block = 43;                  // the last bit is that of (2, 2, 2)

// Returns the position of the lowest bit that is set.
// \param[in] bits not 0
unsigned
lowestBit (std::uint64_t bits)
{
  return static_cast<unsigned> (__builtin_ctzll (bits));
}

std::uint64_t
withoutLowestBit (std::uint64_t bits)
{
  return bits & (bits - 1);
}

/** \brief The 2 x 2 x 2 children of a voxel and the voxels around them: a block of
 * 4 x 4 x 4 cells. Cell (x, y, z) has the index x + 4 y + 16 z. */
struct ChildrenAround {
  static constexpr int cells = 64;
  /** \brief Index that stands for the cells of all voxels outside of the block. */
  static constexpr std::uint8_t outside = 64;

  /** \brief One bit for each cell that holds an occupied voxel. */
  std::uint64_t occupied = 0;
  /** \brief Index of the voxel in each occupied cell; elements of other cells are not
   * set, and that of \ref outside has no meaning. */
  std::array<std::uint32_t, cells + 1> voxels;
};

constexpr int max_children = 8;

// Returns which of the children of its parent a voxel is: the lowest three bits of its
// code. Bits 0, 1 and 2 are set for the upper half of the parent along x, y and z.
unsigned
octantInParent (MortonCode code)
{
  return code & (max_children - 1);
}

/** \brief First index: bit of the parent of a child in \ref VoxelNeighbors::occupied.
 * Second index: octant of the child. Value: cell of the child in \ref ChildrenAround;
 * the children of the parent in the middle are in cells 1 and 2 along each axis. */
using CellsOfChildren =
    std::array<std::array<std::uint8_t, max_children>, bits_of_block>;

constexpr CellsOfChildren
cellsOfChildren ()
{
  CellsOfChildren cells{};
  for (int parent = 0; parent < bits_of_block; ++parent)
    for (int octant = 0; octant < max_children; ++octant) {
      const int x = parent % 4 * 2 + (octant & 1) - 1;
      const int y = parent / 4 % 4 * 2 + (octant >> 1 & 1) - 1;
      const int z = parent / 16 * 2 + (octant >> 2) - 1;
      const bool is_inside = x >= 0 && x < 4 && y >= 0 && y < 4 && z >= 0 && z < 4;
      cells[parent][octant] = is_inside
                                  ? static_cast<std::uint8_t> ((z * 4 + y) * 4 + x)
                                  : ChildrenAround::outside;
    }
  return cells;
}

// For each octant the cell with the lowest index in the 3 x 3 x 3 block around the
// child in this octant: x + 4 y + 16 z, with the bits x, y and z of the octant.
constexpr std::array<std::uint8_t, max_children> first_around{
    0, 1, 4, 5, 16, 17, 20, 21};

// Returns for each parent the index of its first child, then the number of children.
// \param[in] parent_of_child ascending
Indices
firstChildren (const Indices& parent_of_child, std::size_t parents)
{
  Indices first (parents + 1, 0);
  for (const std::uint32_t parent : parent_of_child)
    ++first[parent + 1];
  std::partial_sum (first.begin(), first.end(), first.begin());
  return first;
}

// Collects the children of a voxel and the voxels around them.
// \param[in] codes of the children of all voxels
// \param[in] around_parents neighbors of the voxels of the level of \p parent
// \param[in] parent index of the voxel
ChildrenAround
childrenAround (const std::vector<MortonCode>& codes,
                const Indices& first_child,
                const VoxelNeighbors& around_parents,
                std::size_t parent)
{
  static constexpr CellsOfChildren cells_of_children = cellsOfChildren();
  ChildrenAround children;
  std::uint64_t bits_left = around_parents.occupied[parent];
  for (const std::uint32_t neighbor : around_parents[parent]) {
    const auto& cell_of_octant = cells_of_children[lowestBit (bits_left)];
    bits_left = withoutLowestBit (bits_left);
    for (std::uint32_t child = first_child[neighbor]; child < first_child[neighbor + 1];
         ++child) {
      const unsigned cell = cell_of_octant[octantInParent (codes[child])];
      children.voxels[cell] = child;
      children.occupied |=
          cell == ChildrenAround::outside ? 0 : std::uint64_t (1) << cell;
    }
  }
  return children;
}

// Writes the indices of the neighbors of a child, and VoxelNeighbors::occupied.
// \param[in] children the children of its parent and the voxels around them
// \param[in] octant of the child in its parent
// \param[out] next where to write the indices
// \return the end of the written indices
std::uint32_t*
writeNeighbors (const ChildrenAround& children,
                unsigned octant,
                std::uint64_t& occupied,
                std::uint32_t* next)
{
  const unsigned first_cell = first_around[octant];
  occupied = children.occupied >> first_cell & whole_block;
  for (std::uint64_t bits_left = occupied; bits_left != 0;
       bits_left = withoutLowestBit (bits_left))
    *next++ = children.voxels[first_cell + lowestBit (bits_left)];
  return next;
}

// Finds the neighbors of voxels among the children of their parents' neighbors.
// \param[in] codes of the voxels, ascending
// \param[in] above the parents, with their neighbors
VoxelNeighbors
neighborsBelow (const std::vector<MortonCode>& codes,
                const LargerVoxels& above,
                unsigned threads)
{
  constexpr std::size_t max_neighbors = 27;
  const std::size_t parents = above.codes.size();
  const Indices first_child = firstChildren (above.holding, parents);
  VoxelNeighbors around;
  around.occupied.resize (codes.size());
  around.begin.resize (codes.size() + 1);
  const auto pieces = parallelPieces (
      threads, parents, parents_per_piece, [&] (std::size_t begin, std::size_t end) {
        // A vector would first write zeros, which takes longer than writing
        // the results.
        std::unique_ptr<std::uint32_t[]> found (
            new std::uint32_t[max_neighbors * (first_child[end] - first_child[begin])]);
        std::uint32_t* next = found.get();
        for (std::size_t parent = begin; parent < end; ++parent) {
          const ChildrenAround children =
              childrenAround (codes, first_child, above.neighbors, parent);
          for (std::uint32_t i = first_child[parent]; i < first_child[parent + 1];
               ++i) {
            const std::uint32_t* const own_begin = next;
            next = writeNeighbors (
                children, octantInParent (codes[i]), around.occupied[i], next);
            // The number of neighbors; the sums below make it an index.
            around.begin[i + 1] = static_cast<std::uint32_t> (next - own_begin);
          }
        }
        return found;
      });
  std::partial_sum (around.begin.begin(), around.begin.end(), around.begin.begin());
  around.neighbors.resize (around.begin.back());
  parallelFor (threads, pieces.size(), 1, [&] (std::size_t piece, std::size_t) {
    const std::size_t first = piece * parents_per_piece;
    const std::uint32_t begin = around.begin[first_child[first]];
    const std::uint32_t end =
        around.begin[first_child[std::min (first + parents_per_piece, parents)]];
    std::copy_n (pieces[piece].get(), end - begin, around.neighbors.data() + begin);
  });
  return around;
}

} // namespace

LargerVoxels
largerVoxels (const std::vector<MortonCode>& codes)
{
  LargerVoxels larger;
  larger.holding.reserve (codes.size());
  for (const MortonCode code : codes) {
    const MortonCode larger_code = code / max_children;
    if (larger.codes.empty() || larger.codes.back() != larger_code)
      larger.codes.push_back (larger_code);
    larger.holding.push_back (static_cast<std::uint32_t> (larger.codes.size() - 1));
  }
  return larger;
}

ConnectedVoxels
connected (const std::vector<MortonCode>& codes, unsigned threads)
{
  ConnectedVoxels voxels;
  std::vector<LargerVoxels>& larger = voxels.larger;
  // Returns the codes of the voxels whose parents are larger[level].
  const auto codesBelow = [&] (std::size_t level) -> const std::vector<MortonCode>& {
    return level == 0 ? codes : larger[level - 1].codes;
  };
  while (codesBelow (larger.size()).size() > 1)
    larger.push_back (largerVoxels (codesBelow (larger.size())));
  if (!codes.empty())
    voxels.neighbors = {{0}, {0, 1}, {middle_of_block}}; // of the root: itself
  for (std::size_t level = larger.size(); level-- > 0;) {
    larger[level].neighbors = std::move (voxels.neighbors);
    voxels.neighbors = neighborsBelow (codesBelow (level), larger[level], threads);
  }
  return voxels;
}

} // namespace pcl_ops::internal
