// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxels/voxel_table.h"

#include "base/parallel.h"

#include <algorithm>
#include <numeric>

namespace pcl_ops::internal {

VoxelTable::VoxelTable() : slots_ (1024, 0) {}

std::size_t
VoxelTable::findSlot (BlockKey key) const
{
  // Fibonacci hashing: the high bits of the product are well mixed.
  const std::size_t mask = slots_.size() - 1;
  std::size_t slot =
      static_cast<std::size_t> ((key * 0x9E3779B97F4A7C15u) >> 32) & mask;
  while (slots_[slot] != 0 && blocks_[slots_[slot] - 1].key != key)
    slot = (slot + 1) & mask;
  return slot;
}

std::uint32_t
VoxelTable::findOrAddBlock (BlockKey key)
{
  const std::size_t slot = findSlot (key);
  if (slots_[slot] != 0)
    return slots_[slot] - 1;
  blocks_.emplace_back();
  blocks_.back().key = key;
  blocks_.back().layers.fill (-1);
  slots_[slot] = static_cast<std::uint32_t> (blocks_.size());
  if (2 * blocks_.size() > slots_.size())
    grow();
  return static_cast<std::uint32_t> (blocks_.size() - 1);
}

std::uint32_t
VoxelTable::add (const VoxelKey& key)
{
  Block& block = blocks_[last_block_];
  const auto z = static_cast<std::size_t> (key.z & mask);
  std::int32_t& layer = block.layers[z];
  if (layer < 0)
    layer = layers_.add();
  block.rows[z] = static_cast<std::uint8_t> (block.rows[z] | 1 << (key.y & mask));
  const std::array<std::int32_t, 3> in_block{key.x & mask, key.y & mask, key.z & mask};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    block.touches[axis][0] |= in_block[axis] == 0;
    block.touches[axis][1] |= in_block[axis] == mask;
  }
  const auto number = static_cast<std::uint32_t> (keys_.size());
  layers_[layer][positionInLayer (key)] = static_cast<std::int32_t> (number);
  keys_.push_back (key);
  return number;
}

void
VoxelTable::grow()
{
  slots_.assign (2 * slots_.size(), 0);
  for (std::size_t i = 0; i < blocks_.size(); ++i)
    slots_[findSlot (blocks_[i].key)] = static_cast<std::uint32_t> (i + 1);
}

std::vector<std::uint32_t>
VoxelTable::sort()
{
  order_.resize (blocks_.size());
  std::iota (order_.begin(), order_.end(), 0u);
  std::sort (
      order_.begin(), order_.end(), [this] (std::uint32_t first, std::uint32_t second) {
        return blocks_[first].key < blocks_[second].key;
      });
  std::vector<std::uint32_t> new_number (keys_.size());
  std::vector<VoxelKey> sorted;
  sorted.reserve (keys_.size());
  for (const std::uint32_t block : order_)
    forVoxelsOf (blocks_[block], layers_, [&] (std::int32_t& voxel) {
      const auto number = static_cast<std::uint32_t> (sorted.size());
      new_number[static_cast<std::size_t> (voxel)] = number;
      sorted.push_back (keys_[static_cast<std::size_t> (voxel)]);
      voxel = static_cast<std::int32_t> (number);
    });
  keys_ = std::move (sorted);
  return new_number;
}

namespace {

// Along one axis: the voxels of a block or of one of its neighbours that fall into the
// padded block around it.
struct Overlap {
  int from;
  int size;
  int to;
};

constexpr Overlap
overlapOf (int block_offset, int edge)
{
  if (block_offset < 0)
    return {edge - 1, 1, 0};
  if (block_offset > 0)
    return {0, 1, edge + 1};
  return {0, edge, 1};
}

} // namespace

void
VoxelTable::copyInto (
    PaddedBlock& padded, const Block& block, int dx, int dy, int dz) const
{
  const Overlap x = overlapOf (dx, block_edge), y = overlapOf (dy, block_edge),
                z = overlapOf (dz, block_edge);
  for (int k = 0; k < z.size; ++k) {
    const std::int32_t layer = block.layers[static_cast<std::size_t> (z.from + k)];
    if (layer < 0)
      continue;
    const std::int32_t* const voxels = layers_[layer].data();
    for (int j = 0; j < y.size; ++j)
      std::copy_n (voxels + (y.from + j) * block_edge + x.from,
                   x.size,
                   padded.data() + ((z.to + k) * padded_edge + y.to + j) * padded_edge +
                       x.to);
  }
}

void
VoxelTable::clearAround (const Block& block, PaddedBlock& padded)
{
  constexpr int layer_size = padded_edge * padded_edge;
  for (int z = 0; z < padded_edge; ++z)
    for (int k = std::max (0, z - 2); k <= std::min (mask, z); ++k)
      if (block.layers[static_cast<std::size_t> (k)] >= 0) {
        std::fill_n (padded.data() + z * layer_size, layer_size, -1);
        break;
      }
}

void
VoxelTable::pad (const Block& block, PaddedBlock& padded) const
{
  clearAround (block, padded);
  copyInto (padded, block, 0, 0, 0);
  const VoxelKey corner = cornerOf (block.key);
  const auto is_touched = [&block] (std::size_t axis, int offset) {
    return offset == 0 || block.touches[axis][offset > 0];
  };
  for (int dz = -1; dz <= 1; ++dz)
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const bool is_itself = dx == 0 && dy == 0 && dz == 0;
        if (is_itself || !is_touched (0, dx) || !is_touched (1, dy) ||
            !is_touched (2, dz))
          continue;
        const std::uint32_t found =
            slots_[findSlot (blockKey ({corner.x + dx * block_edge,
                                        corner.y + dy * block_edge,
                                        corner.z + dz * block_edge}))];
        if (found != 0)
          copyInto (padded, blocks_[found - 1], dx, dy, dz);
      }
}

VoxelNeighbours
VoxelTable::neighbours (unsigned threads) const
{
  constexpr std::size_t blocks_per_piece = 32;
  VoxelNeighbours neighbours;
  neighbours.reserve (keys_.size());
  for (const VoxelNeighbours& piece : parallelPieces (
           threads, order_.size(), blocks_per_piece, [this] (auto begin, auto end) {
             return neighboursIn (begin, end);
           }))
    neighbours.append (piece);
  return neighbours;
}

VoxelNeighbours
VoxelTable::neighboursIn (std::size_t first_block, std::size_t last_block) const
{
  VoxelNeighbours neighbours;
  PaddedBlock padded;
  std::array<std::uint32_t, 27> found{};
  for (std::size_t b = first_block; b < last_block; ++b) {
    const Block& block = blocks_[order_[b]];
    pad (block, padded);
    forVoxelsOf (block, layers_, [&] (std::int32_t voxel) {
      const VoxelKey& key = keys_[static_cast<std::size_t> (voxel)];
      const std::int32_t* const corner =
          padded.data() +
          ((key.z & mask) * padded_edge + (key.y & mask)) * padded_edge +
          (key.x & mask);
      std::size_t number = 0;
      for (int dz = 0; dz < 3; ++dz)
        for (int dy = 0; dy < 3; ++dy)
          for (int dx = 0; dx < 3; ++dx) {
            const std::int32_t neighbour =
                corner[(dz * padded_edge + dy) * padded_edge + dx];
            // Written always, counted if there: no branch to mispredict.
            found[number] = static_cast<std::uint32_t> (neighbour);
            number += neighbour >= 0;
          }
      neighbours.add (found.data(), number);
    });
  }
  return neighbours;
}

} // namespace pcl_ops::internal
