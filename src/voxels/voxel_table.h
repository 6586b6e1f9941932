// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "voxels/voxel_grid.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace pcl_ops::internal {

/** \brief Numbers the occupied voxels of an unbounded grid.
 *
 * Voxels are kept in blocks of 8 x 8 x 8 that are looked up by a hash; points that
 * follow each other mostly share a block, and a surface fills a good share of the
 * blocks it crosses. Where points are so far apart that each has a block of its own,
 * that holds the one layer of 8 x 8 which is occupied, and nothing is looked up around
 * it but what a voxel of it touches. */
class VoxelTable {
public:
  VoxelTable();

  /** \brief Number of the voxel; a new one gets the next number. */
  std::uint32_t
  insert (const VoxelKey& key)
  {
    const BlockKey block_key = blockKey (key);
    if (block_key != last_key_) {
      last_block_ = findOrAddBlock (block_key);
      last_key_ = block_key;
    }
    const std::int32_t layer =
        blocks_[last_block_].layers[static_cast<std::size_t> (key.z & mask)];
    const std::int32_t voxel = layer < 0 ? -1 : layers_[layer][positionInLayer (key)];
    return voxel < 0 ? add (key) : static_cast<std::uint32_t> (voxel);
  }

  std::size_t
  size () const
  {
    return keys_.size();
  }

  /** \brief Coordinates of each voxel, by number. */
  const std::vector<VoxelKey>&
  keys () const
  {
    return keys_;
  }

  /** \brief Renumbers the voxels by their coordinates, block after block.
   * \return the new number of each */
  std::vector<std::uint32_t>
  sort ();

  /** \brief Neighbours of each voxel, by number; after \ref sort. */
  VoxelNeighbours
  neighbours (unsigned threads) const;

private:
  using BlockKey = std::uint64_t;
  static constexpr int block_bits = 3;
  static constexpr int block_edge = 1 << block_bits;
  static constexpr int mask = block_edge - 1;
  static constexpr int coordinate_bits = 21;

  /** \brief Voxels of a block that share their z; -1 where there is none. */
  using Layer = std::array<std::int32_t, block_edge * block_edge>;

  /** \brief Layers by number, which stay where they are when there are more: a copy of
   * all would cost as much memory again. */
  class Layers {
  public:
    /** \return the number of a new layer without voxels */
    std::int32_t
    add ()
    {
      if (size_ % piece_size == 0)
        pieces_.emplace_back (new Piece);
      at (pieces_, size_).fill (-1);
      return static_cast<std::int32_t> (size_++);
    }

    Layer&
    operator[] (std::int32_t number)
    {
      return at (pieces_, static_cast<std::size_t> (number));
    }
    const Layer&
    operator[] (std::int32_t number) const
    {
      return at (pieces_, static_cast<std::size_t> (number));
    }

  private:
    static constexpr std::size_t piece_size = 64;
    using Piece = std::array<Layer, piece_size>;
    using Pieces = std::vector<std::unique_ptr<Piece>>;

    static Layer&
    at (const Pieces& pieces, std::size_t number)
    {
      return (*pieces[number / piece_size])[number % piece_size];
    }

    Pieces pieces_;
    std::size_t size_ = 0;
  };

  struct Block {
    BlockKey key = 0;
    /** \brief By z; -1 where there is none. */
    std::array<std::int32_t, block_edge> layers;
    /** \brief By z, a bit for each y that has voxels: most have none where points are
     * far apart. */
    std::array<std::uint8_t, block_edge> rows{};
    /** \brief Whether a voxel touches the block before and the one after, by axis. */
    std::array<std::array<bool, 2>, 3> touches{};
  };

  static BlockKey
  blockKey (const VoxelKey& key)
  {
    return (static_cast<BlockKey> (key.z >> block_bits) << (2 * coordinate_bits)) |
           (static_cast<BlockKey> (key.y >> block_bits) << coordinate_bits) |
           static_cast<BlockKey> (key.x >> block_bits);
  }

  static std::size_t
  positionInLayer (const VoxelKey& key)
  {
    return static_cast<std::size_t> (((key.y & mask) << block_bits) | (key.x & mask));
  }

  /** \brief Number of a new voxel of the block looked up last. */
  std::uint32_t
  add (const VoxelKey& key);
  /** \brief Visits the voxels of a block by z, y and x. */
  template <typename AnyLayers, typename Visit>
  static void
  forVoxelsOf (const Block& block, AnyLayers& layers, Visit&& visit)
  {
    for (std::size_t z = 0; z < block_edge; ++z)
      for (std::size_t y = 0; block.rows[z] >> y != 0; ++y)
        if ((block.rows[z] >> y & 1) != 0) {
          auto* const row = &layers[block.layers[z]][y << block_bits];
          for (std::size_t x = 0; x < block_edge; ++x)
            if (row[x] >= 0)
              visit (row[x]);
        }
  }

  std::size_t
  findSlot (BlockKey key) const;
  std::uint32_t
  findOrAddBlock (BlockKey key);
  void
  grow ();

  /** \brief Numbers of the voxels of a block and of those one voxel around it; -1 where
   * there is none. */
  static constexpr int padded_edge = block_edge + 2;
  using PaddedBlock = std::array<std::int32_t, padded_edge * padded_edge * padded_edge>;
  void
  pad (const Block& block, PaddedBlock& padded) const;
  /** \brief Of a padded block the layers that are next to one of the block. */
  static void
  clearAround (const Block& block, PaddedBlock& padded);
  void
  copyInto (PaddedBlock& padded, const Block& block, int dx, int dy, int dz) const;

  /** \brief Neighbours of the voxels of some of the blocks, in their order. */
  VoxelNeighbours
  neighboursIn (std::size_t first_block, std::size_t last_block) const;

  static VoxelKey
  cornerOf (BlockKey key)
  {
    constexpr BlockKey coordinate_mask = (BlockKey (1) << coordinate_bits) - 1;
    const auto coordinate = [key] (int axis) {
      return static_cast<std::int32_t> ((key >> (axis * coordinate_bits)) &
                                        coordinate_mask)
             << block_bits;
    };
    return {coordinate (0), coordinate (1), coordinate (2)};
  }

  std::vector<VoxelKey> keys_;
  std::vector<Block> blocks_;
  Layers layers_;
  /** \brief The blocks by their coordinates, once sorted. */
  std::vector<std::uint32_t> order_;
  /** \brief Open addressing: block number + 1, 0 for a free slot. */
  std::vector<std::uint32_t> slots_;
  BlockKey last_key_ = ~BlockKey (0);
  std::uint32_t last_block_ = 0;
};

} // namespace pcl_ops::internal
