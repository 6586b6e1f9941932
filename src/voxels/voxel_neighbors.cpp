// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxels/voxel_neighbors.h"

#include "base/parallel.h"

#include <array>
#include <numeric>
#include <utility>

namespace pcl_ops::internal {

namespace {

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

/** \brief The 2 x 2 x 2 children of a voxel and those one around them: 4 x 4 x 4, x
 * fastest. */
struct ChildrenAround {
  /** \brief A bit for each that is occupied. */
  std::uint64_t places = 0;
  /** \brief Number of the voxel; the last is for all that are farther away. */
  std::array<std::uint32_t, 65> voxels;
};

constexpr std::uint8_t far_away = 64;

// Where a child is among \ref ChildrenAround, by the place of its parent around the
// middle one (see \ref VoxelNeighbors::places) and by its octant.
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
      places[static_cast<std::size_t> (parent)][static_cast<std::size_t> (octant)] =
          is_near ? static_cast<std::uint8_t> ((z * 4 + y) * 4 + x) : far_away;
    }
  return places;
}

// The first of the 3 x 3 x 3 around each child.
constexpr std::array<std::uint8_t, 8> first_around{0, 1, 4, 5, 16, 17, 20, 21};

// Where the children of each parent begin, and where the last one's end.
std::vector<std::uint32_t>
firstChildren (const std::vector<std::uint32_t>& parents, std::size_t number)
{
  std::vector<std::uint32_t> first (number + 1, 0);
  for (const std::uint32_t parent : parents)
    ++first[parent + 1];
  std::partial_sum (first.begin(), first.end(), first.begin());
  return first;
}

// The children of a voxel and those around them.
ChildrenAround
childrenAround (const std::vector<MortonCode>& codes,
                const std::vector<std::uint32_t>& first_child,
                const VoxelNeighbors& around_parents,
                std::size_t parent)
{
  static constexpr auto places_of_children = placesOfChildren();
  ChildrenAround children;
  std::uint64_t places = around_parents.places (parent);
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

// Appends a child with those around it.
void
add (const ChildrenAround& children, unsigned first, VoxelNeighbors& neighbors)
{
  const std::uint64_t places = children.places >> first & all_around;
  std::array<std::uint32_t, 27> found;
  std::size_t number = 0;
  for (std::uint64_t left = places; left != 0; left &= left - 1)
    found[number++] = children.voxels[first + lowestBit (left)];
  neighbors.add (found.data(), number, places);
}

// Found among the children of their parents' neighbors.
VoxelNeighbors
neighborsBelow (const std::vector<MortonCode>& codes,
                const LargerVoxels& above,
                unsigned threads)
{
  const VoxelNeighbors& around_parents = above.neighbors;
  const std::vector<std::uint32_t> first_child =
      firstChildren (above.holding, above.codes.size());
  const auto pieces = parallelChunks (
      threads, around_parents.size(), parents_per_piece, [&] (auto begin, auto end) {
        VoxelNeighbors piece;
        for (std::size_t p = begin; p < end; ++p) {
          if (first_child[p] == first_child[p + 1])
            continue;
          const ChildrenAround children =
              childrenAround (codes, first_child, around_parents, p);
          for (std::uint32_t child = first_child[p]; child < first_child[p + 1];
               ++child)
            add (children, first_around[codes[child] & 7], piece);
        }
        return piece;
      });
  VoxelNeighbors neighbors;
  for (const VoxelNeighbors& piece : pieces)
    neighbors.append (piece);
  return neighbors;
}

} // namespace

void
VoxelNeighbors::append (const VoxelNeighbors& other)
{
  const auto before = static_cast<std::uint32_t> (neighbors_.size());
  neighbors_.insert (
      neighbors_.end(), other.neighbors_.begin(), other.neighbors_.end());
  for (std::size_t i = 1; i < other.begin_.size(); ++i)
    begin_.push_back (before + other.begin_[i]);
  places_.insert (places_.end(), other.places_.begin(), other.places_.end());
}

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
  if (const std::uint32_t itself = 0; !codes.empty())
    voxels.neighbors.add (&itself, 1, middle);
  for (std::size_t level = larger.size(); level-- > 0;) {
    larger[level].neighbors = std::move (voxels.neighbors);
    voxels.neighbors = neighborsBelow (codesBelow (level), larger[level], threads);
  }
  return voxels;
}

} // namespace pcl_ops::internal
