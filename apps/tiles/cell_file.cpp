// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cell_file.h"

#include "binary_file.h"

namespace pcl_ops::apps {

void
CellFileWriter::add (const BlockKey& key, const Eigen::Vector3f& point)
{
  constexpr std::size_t most = 1U << 21U;
  if (last_ == waiting_.end() || last_->first != key)
    last_ = waiting_.try_emplace (key).first;
  last_->second.push_back (point);
  if (++points_waiting_ == most)
    flush();
}

void
CellFileWriter::flush()
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

void
CellFileWriter::finish()
{
  flush();
  BinaryWriter write (stream_);
  write (blocks_);
  write (&offset_, 1);
}

CellFile::CellFile (const std::string& file) : file_ (file)
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

std::uint64_t
CellFile::count (const BlockKey& key) const
{
  std::uint64_t points = 0;
  const auto [first, last] = blocks_.equal_range (key);
  for (auto block = first; block != last; ++block)
    points += block->second.points;
  return points;
}

void
CellFile::read (const BlockKey& key, std::vector<Eigen::Vector3f>& points) const
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

} // namespace pcl_ops::apps
