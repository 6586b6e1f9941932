// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tile_planes.h"

#include <cli/errors.h>
#include <io/output_file.h>

#include <algorithm>

namespace pcl_ops::apps {

void
saveTilePlanes (const std::string& file, const TilePlanes& planes)
{
  writeFile (file, [&] (std::ostream& stream) {
    put (stream, std::uint64_t (planes.pieces.size()));
    for (const Piece& piece : planes.pieces) {
      put (stream, piece.own);
      putMoments (stream, piece.all);
      putBytes (stream, piece.normal.data(), 3);
      putAll (stream, piece.edges);
      putAll (stream, piece.inputs);
    }
    putAll (stream, planes.claims);
  });
}

TilePlanes
loadTilePlanes (const std::string& file)
{
  std::ifstream stream = openBinary (file);
  TilePlanes planes;
  planes.pieces.resize (getCount (stream, sizeof (ExactMoments)));
  for (Piece& piece : planes.pieces) {
    piece.own = get<ExactMoments> (stream);
    piece.all = getMoments (stream);
    getBytes (stream, piece.normal.data(), 3);
    piece.edges = getAll<OutlineEdge> (stream);
    piece.inputs = getAll<std::uint32_t> (stream);
  }
  planes.claims = getAll<Claim> (stream);
  checkWasRead (stream, file);
  return planes;
}

void
saveTileLabels (const std::string& file, const std::vector<LabelsOfInput>& labels)
{
  writeFile (file, [&] (std::ostream& stream) {
    put (stream, std::uint64_t (labels.size()));
    for (const LabelsOfInput& some : labels) {
      put (stream, std::uint64_t (some.input));
      put (stream, std::uint64_t (some.labels.size()));
    }
    for (const LabelsOfInput& some : labels)
      putBytes (stream, some.labels.data(), some.labels.size());
  });
}

LabelReader::LabelReader (const std::string& file, std::uint32_t input) : file_ (file)
{
  std::ifstream stream = openBinary (file_);
  const auto inputs = get<std::uint64_t> (stream);
  place_ = (1 + 2 * inputs) * sizeof (std::uint64_t);
  for (std::uint64_t i = 0; i < inputs && stream; ++i) {
    const auto number = get<std::uint64_t> (stream),
               count = get<std::uint64_t> (stream);
    if (number == input)
      left_ = count;
    if (number < input)
      place_ += count * sizeof (std::uint32_t);
  }
  checkWasRead (stream, file_);
}

std::uint32_t
LabelReader::next()
{
  if (used_ == some_.size())
    refill();
  return some_[used_++];
}

void
LabelReader::refill()
{
  constexpr std::uint64_t most = 4096;
  if (left_ == 0)
    throw WorkError (file_, "has too few labels; remove its folder and run it again");
  some_.resize (std::min (most, left_));
  used_ = 0;
  std::ifstream stream = openBinary (file_);
  stream.seekg (static_cast<std::streamoff> (place_));
  getBytes (stream, some_.data(), some_.size());
  checkWasRead (stream, file_);
  place_ += some_.size() * sizeof (std::uint32_t);
  left_ -= some_.size();
}

} // namespace pcl_ops::apps
