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

constexpr std::size_t parents_per_piece = 256;
constexpr std::uint64_t three = 0x7;
constexpr std::uint64_t three_by_three = three | three << 4 | three << 8;
constexpr std::uint64_t all_around =
    three_by_three | three_by_three << 16 | three_by_three << 32;
constexpr std::uint64_t middle = 1 << 21;

// Position of the lowest bit that is set.
unsigned
lowestBit (std::uint64_t bits)
{
  return static_cast<unsigned> (__builtin_ctzll (bits));
}

/** \brief The 2 x 2 x 2 children of a voxel and the voxels around them: a block of
 * 4 x 4 x 4 places, x fastest. */
struct ChildrenAround {
  /** \brief One bit for each occupied place. */
  std::uint64_t places = 0;
  /** \brief Index of the voxel at each place; the last one takes voxels outside. */
  std::array<std::uint32_t, 65> voxels;
};

constexpr std::uint8_t far_away = 64;

// The place of a child in \ref ChildrenAround, or far_away. First index: place of its
// parent, as in \ref VoxelNeighbors::places. Second index: octant of the child.
constexpr std::array<std::array<std::uint8_t, 8>, 43>
placesOfChildren ()
{
  std::array<std::array<std::uint8_t, 8>, 43> places{};
  for (int parent = 0; parent < 43; ++parent)
    for (int octant = 0; octant < 8; ++octant) {
      const int x = parent % 4 * 2 + (octant & 1) - 1;
      const int y = parent / 4 % 4 * 2 + (octant >> 1 & 1) - 1;
      const int z = parent / 16 * 2 + (octant >> 2) - 1;
      const bool is_near = x >= 0 && x < 4 && y >= 0 && y < 4 && z >= 0 && z < 4;
      places[parent][octant] =
          is_near ? static_cast<std::uint8_t> ((z * 4 + y) * 4 + x) : far_away;
    }
  return places;
}

// For each octant the first place of the 3 x 3 x 3 block around the child there.
constexpr std::array<std::uint8_t, 8> first_around{0, 1, 4, 5, 16, 17, 20, 21};

// For each parent the index of its first child, and the number of children.
Indices
firstChildren (const Indices& parents, std::size_t number)
{
  Indices first (number + 1, 0);
  for (const std::uint32_t parent : parents)
    ++first[parent + 1];
  std::partial_sum (first.begin(), first.end(), first.begin());
  return first;
}

// Collects the children of a voxel and the voxels around them.
ChildrenAround
childrenAround (const std::vector<MortonCode>& codes,
                const Indices& first_child,
                const VoxelNeighbors& around_parents,
                std::size_t parent)
{
  static constexpr auto places_of_children = placesOfChildren();
  ChildrenAround children;
  std::uint64_t places = around_parents.places[parent];
  for (const std::uint32_t neighbor : around_parents[parent]) {
    const auto& places_here = places_of_children[lowestBit (places)];
    places &= places - 1;
    for (std::uint32_t child = first_child[neighbor]; child < first_child[neighbor + 1];
         ++child) {
      const unsigned place = places_here[codes[child] & 7];
      children.voxels[place] = child;
      children.places |= place == far_away ? 0 : std::uint64_t (1) << place;
    }
  }
  return children;
}

// Finds the neighbors of voxels among the children of their parents' neighbors.
VoxelNeighbors
neighborsBelow (const std::vector<MortonCode>& codes,
                const LargerVoxels& above,
                unsigned threads)
{
  constexpr std::size_t most = 27;
  const std::size_t parents = above.codes.size();
  const Indices first_child = firstChildren (above.holding, parents);
  VoxelNeighbors around;
  around.places.resize (codes.size());
  around.begin.resize (codes.size() + 1);
  const auto pieces = parallelChunks (
      threads, parents, parents_per_piece, [&] (std::size_t begin, std::size_t end) {
        // A vector would first write zeros, which takes longer than the results.
        std::unique_ptr<std::uint32_t[]> found (
            new std::uint32_t[most * (first_child[end] - first_child[begin])]);
        std::uint32_t* next = found.get();
        for (std::size_t p = begin; p < end; ++p) {
          const ChildrenAround children =
              childrenAround (codes, first_child, above.neighbors, p);
          for (std::uint32_t i = first_child[p]; i < first_child[p + 1]; ++i) {
            const unsigned first = first_around[codes[i] & 7];
            const std::uint32_t* const own = next;
            around.places[i] = children.places >> first & all_around;
            for (std::uint64_t left = around.places[i]; left != 0; left &= left - 1)
              *next++ = children.voxels[first + lowestBit (left)];
            around.begin[i + 1] = static_cast<std::uint32_t> (next - own);
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
    if (larger.codes.empty() || larger.codes.back() != code >> 3)
      larger.codes.push_back (code >> 3);
    larger.holding.push_back (static_cast<std::uint32_t> (larger.codes.size() - 1));
  }
  return larger;
}

ConnectedVoxels
connected (const std::vector<MortonCode>& codes, unsigned threads)
{
  ConnectedVoxels voxels;
  std::vector<LargerVoxels>& larger = voxels.larger;
  const auto codesBelow = [&] (std::size_t level) -> const std::vector<MortonCode>& {
    return level == 0 ? codes : larger[level - 1].codes;
  };
  while (codesBelow (larger.size()).size() > 1)
    larger.push_back (largerVoxels (codesBelow (larger.size())));
  if (!codes.empty())
    voxels.neighbors = {{0}, {0, 1}, {middle}};
  for (std::size_t level = larger.size(); level-- > 0;) {
    larger[level].neighbors = std::move (voxels.neighbors);
    voxels.neighbors = neighborsBelow (codesBelow (level), larger[level], threads);
  }
  return voxels;
}

} // namespace pcl_ops::internal
