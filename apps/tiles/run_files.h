// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <cli/errors.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

// Files that only a run and its continuation read. Checksums of contents and names
// detect files that a bad disk has changed or that were copied to another name.

namespace pcl_ops::apps {

/** \brief FNV-1a over 32-bit words instead of bytes: files that differ in exactly one
 * word have different checksums. */
class Checksum {
public:
  /** \param[in] file its name is part of the checksum, its folder is not */
  explicit Checksum (const std::string& file)
  {
    for (const char c : std::filesystem::path (file).filename().string())
      addWord (static_cast<unsigned char> (c));
  }

  void
  add (const void* bytes, std::size_t size)
  {
    const auto* const begin = static_cast<const char*> (bytes);
    for (std::size_t i = 0; i + sizeof (std::uint32_t) <= size;
         i += sizeof (std::uint32_t)) {
      std::uint32_t word;
      std::memcpy (&word, begin + i, sizeof (word));
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
    constexpr std::uint64_t prime = 0x100000001b3;
    value_ = (value_ ^ word) * prime;
  }

  std::uint64_t value_ = 0xcbf29ce484222325;
};

/** \brief Writes numbers in this machine's representation, and their checksum. */
struct BinaryWriter {
  /** \param[in] file the name it will have */
  BinaryWriter (std::ostream& output, const std::string& file)
  : stream (output), sum (file)
  {}

  template <typename Number>
  void
  operator() (const Number* numbers, std::size_t count)
  {
    static_assert (std::is_trivially_copyable_v<Number>, "a file has its bytes");
    static_assert (sizeof (Number) % sizeof (std::uint32_t) == 0, "a sum has them all");
    stream.write (reinterpret_cast<const char*> (numbers), count * sizeof (Number));
    sum.add (numbers, count * sizeof (Number));
  }

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

/** \brief Reads what \ref BinaryWriter wrote. \throws WorkError that names the file */
struct BinaryReader {
  explicit BinaryReader (const std::string& name)
  : file (name), stream (name, std::ios::binary | std::ios::ate), sum (name)
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
    static_assert (std::is_trivially_copyable_v<Number>, "a file has its bytes");
    if (!stream.read (reinterpret_cast<char*> (numbers), count * sizeof (Number)))
      fail();
    sum.add (numbers, count * sizeof (Number));
  }

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

  /** \throws WorkError unless the checksum of all numbers that were read follows */
  void
  expectSum ()
  {
    std::uint64_t value = 0;
    if (!stream.read (reinterpret_cast<char*> (&value), sizeof (value)) ||
        value != sum.value())
      fail();
  }

  /** \throws WorkError unless \ref expectSum succeeds and the file ends after that */
  void
  finish ()
  {
    expectSum();
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
  std::uint64_t size = 0;
  Checksum sum;
};

/** \brief \ref TileKey of a tile, then 0 for its own points or 1 for its halo. */
using BlockKey = std::array<std::int64_t, 3>;

/** \brief A run of points with the same key in a file, in the order of the input. */
struct Block {
  BlockKey key{};
  std::uint64_t offset = 0, points = 0;
  /** \brief \ref Checksum of the points. */
  std::uint64_t sum = 0;
};

/** \brief Writes points sorted into blocks, with two million in memory at most. */
class CellFileWriter {
public:
  /** \param[in] file the name it will have */
  CellFileWriter (std::ostream& stream, std::string file)
  : stream_ (stream), file_ (std::move (file))
  {}

  /** \param[in] point in the frame of the tile */
  void
  add (const BlockKey& key, const Eigen::Vector3f& point)
  {
    constexpr std::size_t most = 1U << 21U;
    if (last_ == waiting_.end() || last_->first != key)
      last_ = waiting_.try_emplace (key).first;
    last_->second.push_back (point);
    if (++points_waiting_ == most)
      flush();
  }

  /** \brief Writes the remaining points and the index of blocks. */
  void
  finish ()
  {
    flush();
    BinaryWriter write (stream_, file_);
    write (&offset_, 1);
    write (blocks_);
    write.finish();
    stream_.write (reinterpret_cast<const char*> (&offset_), sizeof (offset_));
  }

private:
  void
  flush ()
  {
    for (const auto& [key, points] : waiting_) {
      BinaryWriter write (stream_, file_);
      write (points.front().data(), 3 * points.size());
      blocks_.push_back ({key, offset_, points.size(), write.sum.value()});
      offset_ += points.size() * sizeof (points.front());
    }
    waiting_.clear();
    last_ = waiting_.end();
    points_waiting_ = 0;
  }

  std::ostream& stream_;
  std::string file_;
  std::map<BlockKey, std::vector<Eigen::Vector3f>> waiting_;
  /** \brief Entry of the last key, as the next point mostly has the same key. */
  decltype (waiting_)::iterator last_ = waiting_.end();
  std::size_t points_waiting_ = 0;
  std::uint64_t offset_ = 0;
  std::vector<Block> blocks_;
};

struct CellFile {
  /** \throws WorkError if it cannot be read */
  explicit CellFile (const std::string& name) : file (name)
  {
    const std::uint64_t end_of_points = endOfPoints();
    BinaryReader read (file);
    read.stream.seekg (end_of_points);
    std::uint64_t end = 0;
    read (&end, 1);
    std::vector<Block> all;
    read (all);
    read.expectSum();
    if (end != end_of_points)
      read.fail();
    for (const Block& block : all)
      blocks[block.key].push_back (block);
  }

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
      const std::size_t before = points.size();
      points.resize (before + block.points);
      read.stream.seekg (block.offset);
      read.sum = Checksum (file);
      read (points[before].data(), 3 * block.points);
      if (read.sum.value() != block.sum)
        read.fail();
    }
  }

  /** \brief Offset of the index of blocks, which the last number of the file says. */
  std::uint64_t
  endOfPoints () const
  {
    BinaryReader read (file);
    std::uint64_t end = 0;
    read.stream.seekg (read.size - sizeof (end));
    read (&end, 1);
    return end;
  }

  std::string file;
  /** \brief Blocks by key; those of one key are in the order of their points. */
  std::map<BlockKey, std::vector<Block>> blocks;
};

} // namespace pcl_ops::apps
