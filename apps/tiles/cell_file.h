// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <ostream>
#include <string>
#include <vector>

namespace pcl_ops::apps {

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
  add (const BlockKey& key, const Eigen::Vector3f& point);

  /** \brief Writes what is left, and where all is. */
  void
  finish ();

private:
  void
  flush ();

  std::ostream& stream_;
  using Waiting = std::map<BlockKey, std::vector<Eigen::Vector3f>>;
  Waiting waiting_;
  /** \brief That of the last point, as the next one mostly has it, too. */
  Waiting::iterator last_ = waiting_.end();
  std::size_t points_waiting_ = 0;
  std::uint64_t offset_ = 0;
  std::vector<Block> blocks_;
};

class CellFile {
public:
  /** \throws WorkError if it cannot be read */
  explicit CellFile (const std::string& file);

  /** \brief By key, those of one key in the order of their points. */
  const std::multimap<BlockKey, Block>&
  blocks () const
  {
    return blocks_;
  }

  std::uint64_t
  count (const BlockKey& key) const;

  /** \brief Appends all points of a key, in their order. */
  void
  read (const BlockKey& key, std::vector<Eigen::Vector3f>& points) const;

private:
  std::string file_;
  std::multimap<BlockKey, Block> blocks_;
};

} // namespace pcl_ops::apps
