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
struct BinaryWriter {
  template <typename Number>
  void
  operator() (const Number* numbers, std::size_t count)
  {
    static_assert (std::is_trivially_copyable_v<Number>, "a file has its bytes");
    stream.write (reinterpret_cast<const char*> (numbers), count * sizeof (Number));
  }

  template <typename Number>
  void
  operator() (const std::vector<Number>& numbers)
  {
    const std::uint64_t count = numbers.size();
    (*this) (&count, 1);
    (*this) (numbers.data(), numbers.size());
  }

  std::ostream& stream;
};

/** \brief Reads them, or throws a WorkError that names the file. */
struct BinaryReader {
  explicit BinaryReader (const std::string& name)
  : file (name), stream (name, std::ios::binary | std::ios::ate)
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

  [[noreturn]] void
  fail () const
  {
    throw WorkError (file, "is damaged; remove its folder and run it again");
  }

  std::string file;
  std::ifstream stream;
  std::uint64_t size = 0;
};

/** \brief x and y of a tile, and 0 for its own points or 1 for those of its halo. */
using BlockKey = std::array<std::int64_t, 3>;

/** \brief Some of the points of a key in a file, in the order of the input. */
struct Block {
  BlockKey key{};
  std::uint64_t offset = 0, points = 0;
};

/** \brief Writes points sorted into blocks, with few of them in memory. */
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
    BinaryWriter write{stream_};
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

struct CellFile {
  /** \throws WorkError if it cannot be read */
  explicit CellFile (const std::string& name) : file (name)
  {
    BinaryReader read (file);
    std::uint64_t end_of_points = 0;
    read.stream.seekg (read.size - sizeof (end_of_points));
    read (&end_of_points, 1);
    read.stream.seekg (end_of_points);
    std::vector<Block> all;
    read (all);
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

  /** \brief Appends all points of a key, in their order. */
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
      read (points[before].data(), 3 * block.points);
    }
  }

  std::string file;
  /** \brief By key, those of one in the order of their points. */
  std::map<BlockKey, std::vector<Block>> blocks;
};

} // namespace pcl_ops::apps
