// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "tile_grid.h"

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <map>
#include <ostream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace pcl_ops::apps {

/** \brief Numbers as this machine has them, for files that only a run and its
 * continuation read. */
template <typename Number>
void
putBytes (std::ostream& stream, const Number* numbers, std::size_t count)
{
  static_assert (std::is_trivially_copyable_v<Number>, "a file has its bytes");
  stream.write (reinterpret_cast<const char*> (numbers),
                static_cast<std::streamsize> (count * sizeof (Number)));
}

template <typename Number>
void
getBytes (std::istream& stream, Number* numbers, std::size_t count)
{
  static_assert (std::is_trivially_copyable_v<Number>, "a file has its bytes");
  stream.read (reinterpret_cast<char*> (numbers),
               static_cast<std::streamsize> (count * sizeof (Number)));
}

template <typename Number>
void
put (std::ostream& stream, const Number& number)
{
  putBytes (stream, &number, 1);
}

template <typename Number>
Number
get (std::istream& stream)
{
  Number number{};
  getBytes (stream, &number, 1);
  return number;
}

/** \brief Reads how many parts follow. \return 0, and the stream has failed, where the
 * file has not that many \param[in] part_size the fewest bytes of one */
std::uint64_t
getCount (std::istream& stream, std::size_t part_size);

template <typename Number>
void
putAll (std::ostream& stream, const std::vector<Number>& numbers)
{
  put (stream, std::uint64_t (numbers.size()));
  putBytes (stream, numbers.data(), numbers.size());
}

template <typename Number>
std::vector<Number>
getAll (std::istream& stream)
{
  std::vector<Number> numbers (getCount (stream, sizeof (Number)));
  getBytes (stream, numbers.data(), numbers.size());
  return numbers;
}

/** \brief Opens a file of a run.
 * \throws WorkError that names it if that fails */
std::ifstream
openBinary (const std::string& file);

/** \throws WorkError that names a file of a run, whose numbers make no sense */
[[noreturn]] void
failDamaged (const std::string& file);

/** \throws WorkError that names the file if it ended before what was read from it */
void
checkWasRead (const std::istream& stream, const std::string& file);

/** \brief Whose points a block has: a tile's own, or of its halo. */
struct BlockKey {
  TileKey tile{};
  /** \brief 0 or 1, in as many bytes as the other numbers of the file. */
  std::uint64_t is_halo = 0;

  friend bool
  operator<(const BlockKey& a, const BlockKey& b)
  {
    return std::tie (a.tile, a.is_halo) < std::tie (b.tile, b.is_halo);
  }
};

/** \brief Some of the points of an input, those of one key in their order, as a file
 * has it. */
struct Block {
  BlockKey key;
  std::uint64_t offset = 0;
  std::uint64_t points = 0;
};

/** \brief Writes the points of an input sorted into blocks, with little of it in
 * memory.
 */
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
  flush (const BlockKey& key, std::vector<float>& numbers);
  void
  flushAll ();

  std::ostream& stream_;
  std::map<BlockKey, std::vector<float>> waiting_;
  /** \brief That of the last point, as the next one mostly has it, too. */
  std::pair<const BlockKey, std::vector<float>>* last_ = nullptr;
  std::size_t numbers_waiting_ = 0;
  std::uint64_t offset_ = 0;
  std::vector<Block> blocks_;
};

class CellFile {
public:
  /** \throws WorkError if it cannot be read */
  explicit CellFile (const std::string& file);

  /** \brief By key, those of one key in the order of their points. */
  const std::vector<Block>&
  blocks () const
  {
    return blocks_;
  }

  std::uint64_t
  count (const BlockKey& key) const;

  /** \brief Appends the coordinates of all points of a key, in their order. */
  void
  read (const BlockKey& key, std::vector<float>& coordinates) const;

private:
  using Range =
      std::pair<std::vector<Block>::const_iterator, std::vector<Block>::const_iterator>;

  Range
  blocksOf (const BlockKey& key) const;

  std::string file_;
  std::vector<Block> blocks_;
};

} // namespace pcl_ops::apps
