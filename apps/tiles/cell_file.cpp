// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cell_file.h"

#include "binary_file.h"

#include <algorithm>
#include <type_traits>

namespace pcl_ops::apps {

namespace {

struct BlockRecord {
  std::int64_t x, y;
  std::uint64_t is_halo, offset, points;
};

} // namespace

void
CellFileWriter::add (const BlockKey& key, const Eigen::Vector3f& point)
{
  constexpr std::size_t most_of_one = 3U << 14U, most_of_all = 3U << 21U;
  if (last_ == nullptr || last_->first < key || key < last_->first)
    last_ = &*waiting_.try_emplace (key).first;
  std::vector<float>& numbers = last_->second;
  numbers.insert (numbers.end(), point.data(), point.data() + 3);
  numbers_waiting_ += 3;
  if (numbers.size() >= most_of_one)
    flush (key, numbers);
  if (numbers_waiting_ >= most_of_all)
    flushAll();
}

void
CellFileWriter::flush (const BlockKey& key, std::vector<float>& numbers)
{
  if (numbers.empty())
    return;
  blocks_.push_back ({key, offset_, numbers.size() / 3});
  putBytes (stream_, numbers.data(), numbers.size());
  offset_ += numbers.size() * sizeof (float);
  numbers_waiting_ -= numbers.size();
  numbers.clear();
}

void
CellFileWriter::flushAll()
{
  for (auto& [key, numbers] : waiting_)
    flush (key, numbers);
  waiting_.clear();
  last_ = nullptr;
}

void
CellFileWriter::finish()
{
  flushAll();
  std::stable_sort (blocks_.begin(), blocks_.end(), [] (const auto& a, const auto& b) {
    return a.key < b.key;
  });
  for (const Block& block : blocks_)
    put (stream_,
         BlockRecord{block.key.tile.x,
                     block.key.tile.y,
                     block.key.is_halo ? 1U : 0U,
                     block.offset,
                     block.points});
  put (stream_, std::uint64_t (blocks_.size()));
}

CellFile::CellFile (const std::string& file) : file_ (file)
{
  std::ifstream stream = openBinary (file);
  const auto number_size = static_cast<std::streamoff> (sizeof (std::uint64_t));
  stream.seekg (-number_size, std::ios::end);
  const auto blocks = get<std::uint64_t> (stream);
  checkWasRead (stream, file);
  const auto index_size = static_cast<std::streamoff> (blocks * sizeof (BlockRecord));
  stream.seekg (-number_size - index_size, std::ios::end);
  for (std::uint64_t i = 0; i < blocks && stream; ++i) {
    const auto record = get<BlockRecord> (stream);
    blocks_.push_back (
        {{{record.x, record.y}, record.is_halo != 0}, record.offset, record.points});
  }
  checkWasRead (stream, file);
}

CellFile::Range
CellFile::blocksOf (const BlockKey& key) const
{
  struct ByKey {
    bool
    operator() (const Block& block, const BlockKey& other) const
    {
      return block.key < other;
    }
    bool
    operator() (const BlockKey& other, const Block& block) const
    {
      return other < block.key;
    }
  };
  return std::equal_range (blocks_.begin(), blocks_.end(), key, ByKey());
}

std::uint64_t
CellFile::count (const BlockKey& key) const
{
  const auto [first, last] = blocksOf (key);
  std::uint64_t points = 0;
  for (auto block = first; block != last; ++block)
    points += block->points;
  return points;
}

void
CellFile::read (const BlockKey& key, std::vector<float>& coordinates) const
{
  const auto [first, last] = blocksOf (key);
  if (first == last)
    return;
  std::ifstream stream = openBinary (file_);
  for (auto block = first; block != last; ++block) {
    const std::size_t before = coordinates.size();
    coordinates.resize (before + 3 * block->points);
    stream.seekg (static_cast<std::streamoff> (block->offset));
    getBytes (stream, coordinates.data() + before, 3 * block->points);
  }
  checkWasRead (stream, file_);
}

} // namespace pcl_ops::apps
