// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <cli/errors.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <map>
#include <string>
#include <type_traits>
#include <vector>

// Files that only a run and its continuation read.

namespace pcl_ops::apps {

/** \brief Writes numbers as this machine has them. */
class BinaryWriter {
public:
  explicit BinaryWriter (std::ostream& stream) : stream_ (stream) {}

  template <typename Number>
  void
  operator() (const Number* numbers, std::size_t count)
  {
    static_assert (std::is_trivially_copyable_v<Number>, "a file has its bytes");
    stream_.write (reinterpret_cast<const char*> (numbers), count * sizeof (Number));
  }

  template <typename Number>
  void
  operator() (const std::vector<Number>& numbers)
  {
    const std::uint64_t count = numbers.size();
    (*this) (&count, 1);
    (*this) (numbers.data(), numbers.size());
  }

private:
  std::ostream& stream_;
};

/** \brief Reads them. Where the file is missing, or has not what is asked for, it
 * throws a WorkError. */
class BinaryReader {
public:
  explicit BinaryReader (const std::string& file)
  : file_ (file), stream_ (file, std::ios::binary | std::ios::ate)
  {
    if (!stream_)
      throw WorkError (file, "cannot be read; remove its folder and run it again");
    size_ = stream_.tellg();
    seek (0);
  }

  std::uint64_t
  size () const
  {
    return size_;
  }

  void
  seek (std::uint64_t place)
  {
    stream_.seekg (place);
  }

  template <typename Number>
  void
  operator() (Number* numbers, std::size_t count)
  {
    static_assert (std::is_trivially_copyable_v<Number>, "a file has its bytes");
    if (!stream_.read (reinterpret_cast<char*> (numbers), count * sizeof (Number)))
      fail();
  }

  template <typename Number>
  void
  operator() (std::vector<Number>& numbers)
  {
    std::uint64_t count = 0;
    (*this) (&count, 1);
    if (count > size_ / sizeof (Number))
      fail();
    numbers.resize (count);
    (*this) (numbers.data(), count);
  }

  [[noreturn]] void
  fail () const
  {
    throw WorkError (file_, "is damaged; remove its folder and run it again");
  }

private:
  std::string file_;
  std::ifstream stream_;
  std::uint64_t size_ = 0;
};

/** \brief Whose points a block has: x and y of a tile, and 0 for its own or 1 for those
 * of its halo. */
using BlockKey = std::array<std::int64_t, 3>;

/** \brief Some of the points of an input, those of one key in their order, as a file
 * has it. */
struct Block {
  BlockKey key{};
  std::uint64_t offset = 0, points = 0;
};

/** \brief Writes the points of an input sorted into blocks, with little of it in
 * memory. */
class CellFileWriter {
public:
  explicit CellFileWriter (std::ostream& stream) : stream_ (stream) {}

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

  /** \brief Writes what is left, and where all is. */
  void
  finish ()
  {
    flush();
    BinaryWriter write (stream_);
    write (blocks_);
    write (&offset_, 1);
  }

private:
  void
  flush ()
  {
    for (const auto& [key, points] : waiting_) {
      blocks_.push_back ({key, offset_, points.size()});
      BinaryWriter{stream_}(points.front().data(), 3 * points.size());
      offset_ += points.size() * sizeof (points.front());
    }
    waiting_.clear();
    last_ = waiting_.end();
    points_waiting_ = 0;
  }

  std::ostream& stream_;
  std::map<BlockKey, std::vector<Eigen::Vector3f>> waiting_;
  /** \brief Those of the last key, which the next point mostly has, too. */
  decltype (waiting_)::iterator last_ = waiting_.end();
  std::size_t points_waiting_ = 0;
  std::uint64_t offset_ = 0;
  std::vector<Block> blocks_;
};

class CellFile {
public:
  /** \throws WorkError if it cannot be read */
  explicit CellFile (const std::string& file) : file_ (file)
  {
    BinaryReader read (file);
    std::uint64_t end_of_points = 0;
    read.seek (read.size() - sizeof (end_of_points));
    read (&end_of_points, 1);
    read.seek (end_of_points);
    std::vector<Block> blocks;
    read (blocks);
    for (const Block& block : blocks)
      blocks_.emplace (block.key, block);
  }

  /** \brief By key, those of one key in the order of their points. */
  const std::multimap<BlockKey, Block>&
  blocks () const
  {
    return blocks_;
  }

  std::uint64_t
  count (const BlockKey& key) const
  {
    std::uint64_t points = 0;
    const auto [first, last] = blocks_.equal_range (key);
    for (auto block = first; block != last; ++block)
      points += block->second.points;
    return points;
  }

  /** \brief Appends all points of a key, in their order. */
  void
  read (const BlockKey& key, std::vector<Eigen::Vector3f>& points) const
  {
    const auto [first, last] = blocks_.equal_range (key);
    if (first == last)
      return;
    BinaryReader read (file_);
    for (auto block = first; block != last; ++block) {
      const std::size_t before = points.size();
      points.resize (before + block->second.points);
      read.seek (block->second.offset);
      read (points[before].data(), 3 * block->second.points);
    }
  }

private:
  std::string file_;
  std::multimap<BlockKey, Block> blocks_;
};

} // namespace pcl_ops::apps
