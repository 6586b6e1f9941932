// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cell_file.h"

#include <cli/errors.h>

#include <algorithm>

namespace pcl_ops::apps {

namespace {

bool
isBefore (const Block& a, const Block& b)
{
  return a.key < b.key;
}

} // namespace

std::uint64_t
getCount (std::istream& stream, std::size_t part_size)
{
  const auto count = get<std::uint64_t> (stream);
  const std::istream::pos_type place = stream.tellg();
  stream.seekg (0, std::ios::end);
  const auto left = static_cast<std::uint64_t> (stream.tellg() - place);
  stream.seekg (place);
  if (stream && count <= left / part_size)
    return count;
  stream.setstate (std::ios::failbit);
  return 0;
}

std::ifstream
openBinary (const std::string& file)
{
  std::ifstream stream (file, std::ios::binary);
  if (!stream)
    throw WorkError (file, "cannot be read; remove its folder and run it again");
  return stream;
}

void
failDamaged (const std::string& file)
{
  throw WorkError (file, "is damaged; remove its folder and run it again");
}

void
checkWasRead (const std::istream& stream, const std::string& file)
{
  if (!stream)
    failDamaged (file);
}

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
  std::stable_sort (blocks_.begin(), blocks_.end(), isBefore);
  putBytes (stream_, blocks_.data(), blocks_.size());
  put (stream_, std::uint64_t (blocks_.size()));
}

CellFile::CellFile (const std::string& file) : file_ (file)
{
  std::ifstream stream = openBinary (file);
  stream.seekg (-std::streamoff (sizeof (std::uint64_t)), std::ios::end);
  const std::streamoff end = stream.tellg();
  const auto blocks = get<std::uint64_t> (stream);
  checkWasRead (stream, file);
  if (blocks > std::uint64_t (end) / sizeof (Block))
    failDamaged (file);
  blocks_.resize (blocks);
  stream.seekg (end - std::streamoff (blocks * sizeof (Block)));
  getBytes (stream, blocks_.data(), blocks);
  checkWasRead (stream, file);
}

CellFile::Range
CellFile::blocksOf (const BlockKey& key) const
{
  return std::equal_range (blocks_.begin(), blocks_.end(), Block{key}, isBefore);
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
