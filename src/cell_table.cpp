// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cell_table.h"

#include <algorithm>
#include <numeric>

namespace pcl_ops {

CellTable::CellTable() : slots_ (1024, 0) {}

std::size_t
CellTable::findSlot (BlockKey key) const
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
CellTable::findOrAddBlock (BlockKey key)
{
  const std::size_t slot = findSlot (key);
  if (slots_[slot] != 0)
    return slots_[slot] - 1;
  blocks_.emplace_back();
  blocks_.back().key = key;
  blocks_.back().cells.fill (-1);
  slots_[slot] = static_cast<std::uint32_t> (blocks_.size());
  if (2 * blocks_.size() > slots_.size())
    grow();
  return static_cast<std::uint32_t> (blocks_.size() - 1);
}

void
CellTable::grow()
{
  slots_.assign (2 * slots_.size(), 0);
  for (std::size_t i = 0; i < blocks_.size(); ++i)
    slots_[findSlot (blocks_[i].key)] = static_cast<std::uint32_t> (i + 1);
}

std::vector<std::uint32_t>
CellTable::sort()
{
  std::vector<std::size_t> order (blocks_.size());
  std::iota (order.begin(), order.end(), 0);
  std::sort (
      order.begin(), order.end(), [this] (std::size_t first, std::size_t second) {
        return blocks_[first].key < blocks_[second].key;
      });
  std::vector<std::uint32_t> new_number (keys_.size());
  std::vector<CellKey> sorted;
  sorted.reserve (keys_.size());
  for (const std::size_t block : order)
    for (std::int32_t& cell : blocks_[block].cells)
      if (cell >= 0) {
        const auto number = static_cast<std::uint32_t> (sorted.size());
        new_number[static_cast<std::size_t> (cell)] = number;
        sorted.push_back (keys_[static_cast<std::size_t> (cell)]);
        cell = static_cast<std::int32_t> (number);
      }
  keys_ = std::move (sorted);
  return new_number;
}

namespace {

constexpr int axis_offsets = 3;

// Along one axis: from a coordinate within a block and an offset -1, 0, 1 to the offset
// of the neighbour's block and its coordinate within that.
struct Step {
  std::int32_t block;
  std::int32_t coordinate;
};

constexpr Step
step (std::int32_t coordinate, std::int32_t offset, std::int32_t edge)
{
  const std::int32_t moved = coordinate + offset;
  if (moved < 0)
    return {-1, moved + edge};
  if (moved >= edge)
    return {1, moved - edge};
  return {0, moved};
}

} // namespace

CellTable::BlockNeighbours
CellTable::blocksAround (const Block& block) const
{
  BlockNeighbours around;
  const CellKey corner = cornerOf (block.key);
  std::size_t n = 0;
  for (std::int32_t dz = -1; dz <= 1; ++dz)
    for (std::int32_t dy = -1; dy <= 1; ++dy)
      for (std::int32_t dx = -1; dx <= 1; ++dx) {
        const std::uint32_t found =
            slots_[findSlot (blockKey ({corner.x + dx * block_edge,
                                        corner.y + dy * block_edge,
                                        corner.z + dz * block_edge}))];
        around[n++] = found == 0 ? nullptr : blocks_[found - 1].cells.data();
      }
  return around;
}

Neighbourhood
CellTable::neighbourhood (const CellKey& key, const BlockNeighbours& around)
{
  constexpr std::int32_t mask = block_edge - 1;
  Neighbourhood neighbours;
  std::size_t n = 0;
  for (std::int32_t dz = -1; dz <= 1; ++dz) {
    const Step z = step (key.z & mask, dz, block_edge);
    for (std::int32_t dy = -1; dy <= 1; ++dy) {
      const Step y = step (key.y & mask, dy, block_edge);
      for (std::int32_t dx = -1; dx <= 1; ++dx) {
        const Step x = step (key.x & mask, dx, block_edge);
        const std::int32_t* const cells = around[static_cast<std::size_t> (
            ((z.block + 1) * axis_offsets + y.block + 1) * axis_offsets + x.block + 1)];
        neighbours[n++] =
            cells ? cells[positionInBlock ({x.coordinate, y.coordinate, z.coordinate})]
                  : -1;
      }
    }
  }
  return neighbours;
}

std::vector<Neighbourhood>
CellTable::neighbourhoods() const
{
  std::vector<Neighbourhood> neighbours (keys_.size());
  for (const Block& block : blocks_) {
    const BlockNeighbours around = blocksAround (block);
    for (const std::int32_t cell : block.cells)
      if (cell >= 0) {
        const auto i = static_cast<std::size_t> (cell);
        neighbours[i] = neighbourhood (keys_[i], around);
      }
  }
  return neighbours;
}

} // namespace pcl_ops
