// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "image.h"

#include "colors.h"
#include <cli/errors.h>
#include <io/output_file.h>
#include <png.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace pcl_ops::apps {

namespace {

constexpr int dot = 3; // edge of a dot of a letter, and of a margin [pixel]

/** \brief Letters of 3 x 5 dots: an octal digit for each row from above. */
const std::map<char, unsigned>&
letters ()
{
  static const std::map<char, unsigned> dots = {{'0', 075557},
                                                {'1', 026227},
                                                {'2', 071747},
                                                {'5', 074717},
                                                {'.', 000002},
                                                {'A', 025755},
                                                {'C', 034443},
                                                {'E', 074647},
                                                {'H', 055755},
                                                {'I', 072227},
                                                {'L', 044447},
                                                {'N', 065555},
                                                {'O', 025552},
                                                {'P', 065644},
                                                {'R', 065655},
                                                {'T', 072222},
                                                {'V', 055552},
                                                {'Z', 071247}};
  return dots;
}

} // namespace

void
Image::paint (int column, int row, const pcl::RGB& color, float brightness)
{
  const std::size_t first =
      3U * (static_cast<std::size_t> (row) * width + static_cast<std::size_t> (column));
  const auto dimmed = [brightness] (std::uint8_t part) {
    return static_cast<std::uint8_t> (std::lround (brightness * float (part)));
  };
  bytes[first] = dimmed (color.r);
  bytes[first + 1] = dimmed (color.g);
  bytes[first + 2] = dimmed (color.b);
}

void
Image::fill (int column, int row, int last_column, int last_row, const pcl::RGB& color)
{
  for (int y = row; y < last_row; ++y)
    for (int x = column; x < last_column; ++x)
      paint (x, y, color);
}

int
Image::write (int column, int row, const std::string& text)
{
  constexpr int columns = 3, rows = 5;
  for (const char letter : text) {
    const auto known = letters().find (letter);
    const unsigned dots = known == letters().end() ? 0U : known->second;
    for (int i = 0; i < rows * columns; ++i)
      if (dots >> unsigned (rows * columns - 1 - i) & 1U) {
        const int x = column + dot * (i % columns), y = row + dot * (i / columns);
        fill (x, y, x + dot, y + dot, {0, 0, 0});
      }
    column += dot * (columns + 1);
  }
  return column;
}

void
Image::addLegend (int lines)
{
  constexpr int line = 8 * dot, box = 5 * dot, longest = 11 * 4 * dot;
  const std::pair<const char*, pcl::RGB> entries[] = {
      {"HORIZONTAL", colorOf (Orientation::Horizontal)},
      {"VERTICAL", colorOf (Orientation::Vertical)},
      {"OTHER", colorOf (Orientation::Other)},
      {"NO PLANE", colorOfLabel (0)}};
  const int left = half_width + gap;
  int row = height - lines * line;
  fill (left,
        height - legend_height,
        left + box + longest + 3 * dot,
        height,
        {255, 255, 255});
  for (int i = 0; i < lines; ++i, row += line) {
    fill (left + dot, row, left + dot + box, row + box, entries[i].second);
    write (left + 3 * dot + box, row, entries[i].first);
  }
}

void
savePng (const std::string& file, const Image& image)
{
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = Image::width;
  header.height = Image::height;
  header.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX (header);
  std::string png (size, '\0');
  if (png_image_write_to_memory (
          &header, png.data(), &size, 0, image.bytes.data(), 0, nullptr) == 0)
    throw WorkError (
        file, std::string ("cannot be drawn (") + header.message + "); leave it out");
  png.resize (size);
  writeTextFile (file, png);
}

} // namespace pcl_ops::apps
