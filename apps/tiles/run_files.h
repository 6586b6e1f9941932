// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "tile_grid.h"
#include <cli/errors.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

// Binary files that a run writes for its later phases, or for a run that continues it.
// Checksums of contents and names detect files that a bad disk has changed or that were
// copied to another name.

namespace pcl_ops::apps {

/** \brief The hash FNV-1a over 32-bit words instead of bytes. Files that differ in
 * exactly one word have different checksums. */
class Checksum {
public:
  /** \param[in] file path of the file: its name is part of the checksum, its folder is
   * not */
  explicit Checksum (const std::string& file)
  {
    for (const char letter : std::filesystem::path (file).filename().string())
      addWord (static_cast<unsigned char> (letter));
  }

  /** \brief Adds bytes, as 32-bit words.
   * \param[in] size number of bytes, a multiple of 4 */
  void
  add (const void* bytes, std::size_t size)
  {
    const auto* const begin = static_cast<const char*> (bytes);
    for (std::size_t offset = 0; offset + sizeof (std::uint32_t) <= size;
         offset += sizeof (std::uint32_t)) {
      std::uint32_t word;
      std::memcpy (&word, begin + offset, sizeof (word));
      addWord (word);
    }
  }

  std::uint64_t
  value () const
  {
    return value_;
  }

private:
  void
  addWord (std::uint32_t word)
  {
    constexpr std::uint64_t fnv_prime = 0x100000001b3;
    value_ = (value_ ^ word) * fnv_prime;
  }

  static constexpr std::uint64_t fnv_offset_basis = 0xcbf29ce484222325;
  std::uint64_t value_ = fnv_offset_basis;
};

/** \brief Writes numbers in this machine's representation, and their checksum. */
struct BinaryWriter {
  /** \param[in] file name that the file will have, for the checksum */
  BinaryWriter (std::ostream& output, const std::string& file)
  : stream (output), sum (file)
  {}

  template <typename Number>
  void
  operator() (const Number* numbers, std::size_t count)
  {
    static_assert (std::is_trivially_copyable_v<Number>, "bytes are written");
    static_assert (sizeof (Number) % sizeof (std::uint32_t) == 0,
                   "the checksum is over whole words");
    stream.write (reinterpret_cast<const char*> (numbers), count * sizeof (Number));
    sum.add (numbers, count * sizeof (Number));
  }

  /** \brief Writes the length of a list, then its numbers. */
  template <typename Number>
  void
  operator() (const std::vector<Number>& numbers)
  {
    const std::uint64_t count = numbers.size();
    (*this) (&count, 1);
    (*this) (numbers.data(), numbers.size());
  }

  /** \brief Writes the checksum of all numbers. */
  void
  finish ()
  {
    const std::uint64_t value = sum.value();
    stream.write (reinterpret_cast<const char*> (&value), sizeof (value));
  }

  std::ostream& stream;
  Checksum sum;
};

/** \brief Reads what \ref BinaryWriter wrote. All functions throw a WorkError that
 * names the file if it cannot be read or is damaged. */
struct BinaryReader {
  explicit BinaryReader (const std::string& path)
  : file (path), stream (path, std::ios::binary | std::ios::ate), sum (path)
  {
    if (!stream)
      throw WorkError (file, "cannot be read; remove its folder and run it again");
    size = stream.tellg();
    stream.seekg (0);
  }

  template <typename Number>
  void
  operator() (Number* numbers, std::size_t count)
  {
    static_assert (std::is_trivially_copyable_v<Number>, "bytes are read");
    if (!stream.read (reinterpret_cast<char*> (numbers), count * sizeof (Number)))
      fail();
    sum.add (numbers, count * sizeof (Number));
  }

  /** \brief Reads the length of a list, then its numbers. */
  template <typename Number>
  void
  operator() (std::vector<Number>& numbers)
  {
    std::uint64_t count = 0;
    (*this) (&count, 1);
    if (count > size / sizeof (Number))
      fail();
    numbers.resize (count);
    (*this) (numbers.data(), count);
  }

  /** \brief Reads a checksum and compares it with that of all numbers read so far. */
  void
  expectChecksum ()
  {
    std::uint64_t value = 0;
    if (!stream.read (reinterpret_cast<char*> (&value), sizeof (value)) ||
        value != sum.value())
      fail();
  }

  /** \brief Checks the checksum, and that the file ends after it. */
  void
  finish ()
  {
    expectChecksum();
    if (static_cast<std::uint64_t> (stream.tellg()) != size)
      fail();
  }

  [[noreturn]] void
  fail () const
  {
    throw WorkError (file, "is damaged; remove its folder and run it again");
  }

  std::string file;
  std::ifstream stream;
  /** \brief Size of the file [bytes]. */
  std::uint64_t size = 0;
  Checksum sum;
};

/** \brief Where points that a tile sees are: in the tile itself (its own points), or in
 * its halo. 64 bits, so that \ref Block has no padding, whose undefined bytes would
 * change the checksum. */
enum class TilePart : std::int64_t { Own = 0, Halo = 1 };

/** \brief The tile that sees the points of a block, and whether these are its own
 * points or those in its halo. */
struct BlockKey {
  TileKey tile{};
  TilePart part = TilePart::Own;

  friend bool
  operator<(const BlockKey& a, const BlockKey& b)
  {
    return std::tie (a.tile, a.part) < std::tie (b.tile, b.part);
  }

  friend bool
  operator== (const BlockKey& a, const BlockKey& b)
  {
    return a.tile == b.tile && a.part == b.part;
  }
};

/** \brief Consecutive points in a file that have the same key, in the order of the
 * input.
 */
struct Block {
  BlockKey key{};
  /** \brief Offset of the first point in the file [bytes]. */
  std::uint64_t offset = 0;
  /** \brief Number of points. */
  std::uint64_t points = 0;
  /** \brief \ref Checksum of the points. */
  std::uint64_t checksum = 0;
};

/** \brief Writes the points of one input, sorted into blocks. The file has the points
 * of all blocks, then an index: its own offset in the file, the list of blocks and the
 * checksum of both. The last number of the file is the offset of the index again, by
 * which readers find it. */
class BlockFileWriter {
public:
  /** \param[in] file name that the file will have, for checksums */
  BlockFileWriter (std::ostream& stream, std::string file)
  : stream_ (stream), file_ (std::move (file))
  {}

  /** \brief Adds a point to the blocks of a key.
   * \param[in] point in the frame of the key's tile [m] */
  void
  add (const BlockKey& key, const Eigen::Vector3f& point)
  {
    constexpr std::size_t max_points_in_memory = 1U << 21U; // 24 MiB
    if (last_entry_ == unwritten_.end() || !(last_entry_->first == key))
      last_entry_ = unwritten_.try_emplace (key).first;
    last_entry_->second.push_back (point);
    if (++points_unwritten_ == max_points_in_memory)
      flush();
  }

  /** \brief Writes the remaining points and the index of blocks. */
  void
  finish ()
  {
    flush();
    BinaryWriter write (stream_, file_);
    const std::uint64_t index_offset = offset_;
    write (&index_offset, 1);
    write (blocks_);
    write.finish();
    stream_.write (reinterpret_cast<const char*> (&index_offset),
                   sizeof (index_offset));
  }

private:
  /** \brief Writes a block for each key with unwritten points. */
  void
  flush ()
  {
    for (const auto& [key, points] : unwritten_) {
      BinaryWriter write (stream_, file_);
      write (points.front().data(), 3 * points.size());
      blocks_.push_back ({key, offset_, points.size(), write.sum.value()});
      offset_ += points.size() * sizeof (points.front());
    }
    unwritten_.clear();
    last_entry_ = unwritten_.end();
    points_unwritten_ = 0;
  }

  std::ostream& stream_;
  std::string file_;
  /** \brief The points that are not written yet, by their keys. */
  std::map<BlockKey, std::vector<Eigen::Vector3f>> unwritten_;
  /** \brief Entry of the last point: the next point mostly has the same key. */
  decltype (unwritten_)::iterator last_entry_ = unwritten_.end();
  /** \brief Number of all points in \ref unwritten_. */
  std::size_t points_unwritten_ = 0;
  /** \brief Offset of the next block, or of the index [bytes]. */
  std::uint64_t offset_ = 0;
  std::vector<Block> blocks_;
};

/** \brief Reads the points of a file that \ref BlockFileWriter wrote; only its index is
 * in memory. */
struct BlockFile {
  /** \throws WorkError if the file cannot be read */
  explicit BlockFile (const std::string& path) : file (path)
  {
    const std::uint64_t index_offset = indexOffset();
    BinaryReader read (file);
    read.stream.seekg (index_offset);
    std::uint64_t repeated_offset = 0;
    read (&repeated_offset, 1);
    std::vector<Block> all_blocks;
    read (all_blocks);
    read.expectChecksum();
    if (repeated_offset != index_offset)
      read.fail();
    for (const Block& block : all_blocks)
      blocks[block.key].push_back (block);
  }

  /** \brief Returns the number of points of a key. */
  std::uint64_t
  count (const BlockKey& key) const
  {
    std::uint64_t points = 0;
    if (const auto found = blocks.find (key); found != blocks.end())
      for (const Block& block : found->second)
        points += block.points;
    return points;
  }

  /** \brief Appends all points of a key, in the order of the input. */
  void
  read (const BlockKey& key, std::vector<Eigen::Vector3f>& points) const
  {
    const auto found = blocks.find (key);
    if (found == blocks.end())
      return;
    BinaryReader read (file);
    for (const Block& block : found->second) {
      const std::size_t first = points.size(); // of this block
      points.resize (first + block.points);
      read.stream.seekg (block.offset);
      read.sum = Checksum (file);
      read (points[first].data(), 3 * block.points);
      if (read.sum.value() != block.checksum)
        read.fail();
    }
  }

  /** \brief Returns the offset of the index of blocks: the last number of the file. */
  std::uint64_t
  indexOffset () const
  {
    BinaryReader read (file);
    std::uint64_t offset = 0;
    read.stream.seekg (read.size - sizeof (offset));
    read (&offset, 1);
    return offset;
  }

  std::string file;
  /** \brief The blocks of each key, in the order of the file. */
  std::map<BlockKey, std::vector<Block>> blocks;
};

} // namespace pcl_ops::apps
