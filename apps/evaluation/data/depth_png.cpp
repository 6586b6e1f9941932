// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "depth_png.h"

#include <boost/crc.hpp>
#include <boost/iostreams/device/array.hpp>
#include <boost/iostreams/filter/zlib.hpp>
#include <boost/iostreams/filtering_stream.hpp>

#include <cli/errors.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

namespace pcl_ops::evaluation {

namespace {

using Bytes = std::vector<char>;

/** Two bytes per pixel: the distance to the "left" byte of the row filters. */
constexpr std::size_t bytes_per_pixel = 2;
/** Far above any depth camera, far below what would exhaust the memory. */
constexpr std::size_t max_pixels = 100'000'000;

struct Header {
  std::uint32_t width;
  std::uint32_t height;
  std::uint8_t bit_depth;
  std::uint8_t color_type;
  std::uint8_t interlacing;
};

struct PngError {
  std::string what;
};

std::uint32_t
bigEndian32 (const char* bytes)
{
  std::uint32_t value = 0;
  for (int i = 0; i < 4; ++i)
    value = value << 8 | static_cast<std::uint8_t> (bytes[i]);
  return value;
}

Bytes
readBytes (const std::string& file)
{
  std::ifstream stream (file, std::ios::binary);
  Bytes bytes (std::istreambuf_iterator<char> (stream), {});
  if (bytes.empty())
    throw PngError{"cannot be read or is empty"};
  return bytes;
}

struct Chunk {
  std::string type;
  const char* data;
  std::size_t size;
};

/** The chunk at \p offset, its checksum verified; moves the offset behind it. */
Chunk
nextChunk (const Bytes& bytes, std::size_t& offset)
{
  constexpr std::size_t frame = 12; // length, type and checksum, four bytes each
  if (bytes.size() - offset < frame)
    throw PngError{"is truncated"};
  const std::size_t size = bigEndian32 (&bytes[offset]);
  if (bytes.size() - offset - frame < size)
    throw PngError{"is truncated"};
  const Chunk chunk{{&bytes[offset + 4], 4}, &bytes[offset + 8], size};
  boost::crc_32_type checksum;
  checksum.process_bytes (&bytes[offset + 4], 4 + size);
  if (checksum.checksum() != bigEndian32 (chunk.data + size))
    throw PngError{"is damaged: a checksum is wrong"};
  offset += frame + size;
  return chunk;
}

Header
headerOf (const Chunk& chunk)
{
  if (chunk.type != "IHDR" || chunk.size != 13)
    throw PngError{"has no image header"};
  const auto byte = [&] (std::size_t i) {
    return static_cast<std::uint8_t> (chunk.data[i]);
  };
  const Header header{bigEndian32 (chunk.data),
                      bigEndian32 (chunk.data + 4),
                      byte (8),
                      byte (9),
                      byte (12)};
  if (header.bit_depth != 16 || header.color_type != 0)
    throw PngError{"is no depth image: " + std::to_string (header.bit_depth) +
                   " bits per channel, color type " +
                   std::to_string (header.color_type) + ", not 16-bit grey"};
  if (header.interlacing != 0)
    throw PngError{"is interlaced, which depth images are not"};
  if (header.width == 0 || header.height == 0 ||
      header.width > max_pixels / header.height)
    throw PngError{"has an impossible size of " + std::to_string (header.width) +
                   " x " + std::to_string (header.height) + " pixels"};
  return header;
}

/** Image header and the compressed image of all data chunks. */
std::pair<Header, Bytes>
readChunks (const Bytes& bytes)
{
  const std::string signature = "\x89PNG\r\n\x1a\n";
  if (bytes.size() < signature.size() ||
      !std::equal (signature.begin(), signature.end(), bytes.begin()))
    throw PngError{"is no PNG file"};
  std::size_t offset = signature.size();
  const Header header = headerOf (nextChunk (bytes, offset));
  Bytes compressed;
  while (true) {
    const Chunk chunk = nextChunk (bytes, offset);
    if (chunk.type == "IEND")
      return {header, compressed};
    if (chunk.type == "IDAT")
      compressed.insert (compressed.end(), chunk.data, chunk.data + chunk.size);
  }
}

Bytes
inflate (const Bytes& compressed, std::size_t size)
{
  namespace io = boost::iostreams;
  io::filtering_istream stream;
  stream.push (io::zlib_decompressor());
  stream.push (io::array_source (compressed.data(), compressed.size()));
  Bytes bytes (size);
  try {
    stream.read (bytes.data(), static_cast<std::streamsize> (size));
  }
  catch (const std::exception&) {
    stream.setstate (std::ios::failbit);
  }
  if (!stream)
    throw PngError{"is damaged: it holds less than its size says"};
  return bytes;
}

/** The predictor "Paeth" of the standard: the neighbour nearest to left + up - corner.
 */
int
paeth (int left, int up, int corner)
{
  const int to_left = std::abs (up - corner), to_up = std::abs (left - corner),
            to_corner = std::abs (left + up - 2 * corner);
  if (to_left <= to_up && to_left <= to_corner)
    return left;
  return to_up <= to_corner ? up : corner;
}

int
predict (int filter, int left, int up, int corner)
{
  switch (filter) {
  case 0:
    return 0;
  case 1:
    return left;
  case 2:
    return up;
  case 3:
    return (left + up) / 2;
  case 4:
    return paeth (left, up, corner);
  }
  throw PngError{"is damaged: it has an unknown row filter"};
}

/** Turns differences to predictions into bytes, in place; each row starts with the
 * number of its filter. */
void
undoRowFilters (Bytes& bytes, std::size_t row_size)
{
  const auto byte = [&] (std::size_t i) {
    return static_cast<std::uint8_t> (bytes[i]);
  };
  for (std::size_t row = 0; row < bytes.size(); row += row_size)
    for (std::size_t column = 1; column < row_size; ++column) {
      const std::size_t i = row + column;
      const bool has_left = column > bytes_per_pixel, has_up = row > 0;
      const int left = has_left ? byte (i - bytes_per_pixel) : 0;
      const int up = has_up ? byte (i - row_size) : 0;
      const int corner = has_left && has_up ? byte (i - row_size - bytes_per_pixel) : 0;
      bytes[i] = static_cast<char> (byte (i) + predict (byte (row), left, up, corner));
    }
}

DepthImage
decode (const Bytes& bytes)
{
  const auto [header, compressed] = readChunks (bytes);
  const std::size_t row_size = 1 + bytes_per_pixel * header.width;
  Bytes rows = inflate (compressed, row_size * header.height);
  undoRowFilters (rows, row_size);

  DepthImage image{header.width, header.height, {}};
  image.values.reserve (image.width * image.height);
  for (std::size_t row = 0; row < rows.size(); row += row_size)
    for (std::size_t i = row + 1; i < row + row_size; i += bytes_per_pixel)
      image.values.push_back (
          static_cast<std::uint16_t> (static_cast<std::uint8_t> (rows[i]) << 8 |
                                      static_cast<std::uint8_t> (rows[i + 1])));
  return image;
}

} // namespace

DepthImage
readDepthPng (const std::string& file)
{
  try {
    return decode (readBytes (file));
  }
  catch (const PngError& error) {
    throw apps::WorkError (file, error.what + "; get the file again");
  }
}

} // namespace pcl_ops::evaluation
