// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/cell_grid.h>

#include <array>
#include <cstdint>
#include <vector>

namespace pcl_ops {

/** \brief Numbers the occupied cells of an unbounded grid.
 *
 * Cells are kept in blocks of 8 x 8 x 8 that are looked up by a hash; points that
 * follow each other mostly share a block, and a surface fills a good share of the
 * blocks it crosses. */
class CellTable {
public:
  CellTable();

  /** \brief Number of the cell; a new one gets the next number. */
  std::uint32_t
  insert (const CellKey& key)
  {
    const BlockKey block_key = blockKey (key);
    if (block_key != last_key_) {
      last_block_ = findOrAddBlock (block_key);
      last_key_ = block_key;
    }
    std::int32_t& cell = blocks_[last_block_].cells[positionInBlock (key)];
    if (cell < 0) {
      cell = static_cast<std::int32_t> (keys_.size());
      keys_.push_back (key);
    }
    return static_cast<std::uint32_t> (cell);
  }

  std::size_t
  size () const
  {
    return keys_.size();
  }

  /** \brief Coordinates of each cell, by number. */
  const std::vector<CellKey>&
  keys () const
  {
    return keys_;
  }

  /** \brief Renumbers the cells by their coordinates, block after block.
   * \return the new number of each */
  std::vector<std::uint32_t>
  sort ();

  /** \brief Neighbours of each cell, by number; after \ref sort. */
  CellNeighbours
  neighbours (unsigned threads) const;

private:
  using BlockKey = std::uint64_t;
  static constexpr int block_bits = 3;
  static constexpr int block_edge = 1 << block_bits;
  static constexpr int coordinate_bits = 21;

  struct Block {
    BlockKey key = 0;
    std::array<std::int32_t, block_edge * block_edge * block_edge> cells;
  };

  static BlockKey
  blockKey (const CellKey& key)
  {
    return (static_cast<BlockKey> (key.z >> block_bits) << (2 * coordinate_bits)) |
           (static_cast<BlockKey> (key.y >> block_bits) << coordinate_bits) |
           static_cast<BlockKey> (key.x >> block_bits);
  }

  static std::size_t
  positionInBlock (const CellKey& key)
  {
    constexpr int mask = block_edge - 1;
    return static_cast<std::size_t> (
        ((((key.z & mask) << block_bits) | (key.y & mask)) << block_bits) |
        (key.x & mask));
  }

  std::size_t
  findSlot (BlockKey key) const;
  std::uint32_t
  findOrAddBlock (BlockKey key);
  void
  grow ();

  /** \brief Numbers of the cells of a block and of those one cell around it; -1 where
   * there is none. */
  static constexpr int padded_edge = block_edge + 2;
  using PaddedBlock = std::array<std::int32_t, padded_edge * padded_edge * padded_edge>;
  void
  pad (const Block& block, PaddedBlock& padded) const;

  /** \brief Neighbours of the cells of some of the blocks, in their order. */
  CellNeighbours
  neighboursIn (std::size_t first_block, std::size_t last_block) const;

  static CellKey
  cornerOf (BlockKey key)
  {
    constexpr BlockKey mask = (BlockKey (1) << coordinate_bits) - 1;
    const auto coordinate = [key] (int axis) {
      return static_cast<std::int32_t> ((key >> (axis * coordinate_bits)) & mask)
             << block_bits;
    };
    return {coordinate (0), coordinate (1), coordinate (2)};
  }

  std::vector<CellKey> keys_;
  std::vector<Block> blocks_;
  /** \brief The blocks by their coordinates, once sorted. */
  std::vector<std::uint32_t> order_;
  /** \brief Open addressing: block number + 1, 0 for a free slot. */
  std::vector<std::uint32_t> slots_;
  BlockKey last_key_ = ~BlockKey (0);
  std::uint32_t last_block_ = 0;
};

} // namespace pcl_ops
