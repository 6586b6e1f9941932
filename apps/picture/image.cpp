// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "image.h"

#include <Eigen/Geometry>

#include <cli/errors.h>
#include <io/output_file.h>
#include <png.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <string_view>

namespace pcl_ops::apps {

namespace {

constexpr int dot = 3; // edge of a dot of a letter, and of a margin [pixel]

/** \brief Letters of 3 x 5 dots: one octal digit for each row, from the top. */
constexpr std::string_view letters = "0125.ACEHILNOPRTVZ";
constexpr std::string_view rows_of_letters =
    "755572622771747747170000225755344437464755755722274444765555255526564465655"
    "722225555271247";

constexpr int margin = 12;

/** \brief Transforms x and y of the map to columns and rows of the image. */
struct MapScale {
  explicit MapScale (const std::vector<MapShape>& shapes)
  {
    Eigen::AlignedBox2d box;
    for (const MapShape& shape : shapes)
      for (const auto& ring : shape.rings)
        for (const Eigen::Vector3d& corner : ring)
          box.extend (corner.head<2>());
    if (box.isEmpty())
      return;
    const Eigen::Array2d room (Image::half_width - 2 * margin,
                               Image::height - Image::legend_height - 2 * margin);
    const double pixels = (room / box.sizes().array()).minCoeff();
    per_unit = std::isfinite (pixels) ? pixels : 1.0;
    first = {box.min().x(), box.max().y()};
  }

  Eigen::Vector2d
  pixel (const Eigen::Vector3d& corner) const
  {
    return {margin + per_unit * (corner.x() - first.x()),
            margin + per_unit * (first.y() - corner.y())};
  }

  double per_unit = 1.0;
  Eigen::Vector2d first = Eigen::Vector2d::Zero();
};

/** \brief Fills all rings of a shape together, row by row, by the even-odd rule. */
void
draw (const MapShape& shape, const MapScale& scale, Image& image)
{
  const auto row_of = [] (double y) { return static_cast<int> (std::ceil (y - 0.5)); };
  std::map<int, std::vector<double>> crossings; // columns, with the middle of each row
  for (const auto& ring : shape.rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      Eigen::Vector2d a = scale.pixel (ring[i]);
      Eigen::Vector2d b = scale.pixel (ring[(i + 1) % ring.size()]);
      if (a.y() > b.y())
        a.swap (b);
      for (int row = row_of (a.y()); row < row_of (b.y()); ++row)
        crossings[row].push_back (a.x() + (row + 0.5 - a.y()) / (b.y() - a.y()) *
                                              (b.x() - a.x()));
    }
  constexpr int half = Image::half_width + Image::gap;
  for (auto& [row, columns] : crossings) {
    std::sort (columns.begin(), columns.end());
    for (std::size_t i = 0; i + 1 < columns.size(); i += 2) {
      const int begin = int (columns[i]); // walls are lines of a pixel
      const int end = std::max (begin + 1, int (columns[i + 1]));
      image.fill (begin, row, end, row + 1, colorOfLabel (shape.id));
      image.fill (begin + half, row, end + half, row + 1, colorOf (shape.orientation));
    }
  }
}

/** \brief A number that is 1, 2 or 5 times a power of ten, without an exponent. */
std::string
roundText (double number)
{
  std::ostringstream text;
  text << std::fixed;
  text.precision (number < 1.0 ? int (std::ceil (-std::log10 (number))) : 0);
  text << number;
  return text.str();
}

/** \brief Draws a scale bar: 1, 2 or 5 times a power of ten, at most a third of the
 * width of the map. */
void
addScaleBar (const MapScale& scale, Image& image)
{
  const double longest = Image::half_width / 3.0 / scale.per_unit;
  const double power = std::pow (10.0, std::floor (std::log10 (longest)));
  double length = power;
  for (const double factor : {2.0, 5.0})
    if (factor * power <= longest)
      length = factor * power;
  constexpr int bar = 6;
  constexpr int row = Image::height - 3 * margin;
  const int end = margin + int (std::lround (length * scale.per_unit));
  image.fill (margin, row, end, row + bar, {0, 0, 0});
  image.write (end + margin, row - bar, roundText (length));
}

} // namespace

void
Image::paint (int column, int row, const pcl::RGB& color, float brightness)
{
  std::uint8_t* byte = &bytes[3U * static_cast<std::size_t> (row * width + column)];
  for (const std::uint8_t part : {color.r, color.g, color.b})
    *byte++ = static_cast<std::uint8_t> (std::lround (brightness * float (part)));
}

void
Image::fill (int column, int row, int last_column, int last_row, const pcl::RGB& color)
{
  for (int y = row; y < last_row; ++y)
    for (int x = column; x < last_column; ++x)
      paint (x, y, color);
}

void
Image::write (int column, int row, const std::string& text)
{
  constexpr std::size_t columns = 3;
  constexpr std::size_t rows = 5;
  for (const char letter : text) {
    const std::size_t known = letters.find (letter);
    for (std::size_t i = 0; known < letters.size() && i < rows * columns; ++i)
      if (rows_of_letters[rows * known + i / columns] >> (2 - i % columns) & 1) {
        const int x = column + dot * int (i % columns);
        const int y = row + dot * int (i / columns);
        fill (x, y, x + dot, y + dot, {0, 0, 0});
      }
    column += dot * int (columns + 1);
  }
}

void
Image::addLegend (int lines)
{
  constexpr int line = 8 * dot;
  constexpr int box = 5 * dot;
  constexpr int longest = 11 * 4 * dot;
  const std::pair<const char*, pcl::RGB> entries[] = {
      {"HORIZONTAL", colorOf (Orientation::Horizontal)},
      {"VERTICAL", colorOf (Orientation::Vertical)},
      {"OTHER", colorOf (Orientation::Other)},
      {"NO PLANE", colorOfLabel (0)}};
  const int left = half_width + gap;
  int row = height - lines * line;
  const int right = left + box + longest + 3 * dot;
  fill (left, height - legend_height, right, height, {255, 255, 255});
  for (int i = 0; i < lines; ++i, row += line) {
    fill (left + dot, row, left + dot + box, row + box, entries[i].second);
    write (left + 3 * dot + box, row, entries[i].first);
  }
}

void
Image::addLegend (const ColorScale& scale)
{
  constexpr int letter = 4 * dot;
  constexpr int line = 5 * dot;
  constexpr int bar = 256;
  const std::string from = roundText (scale.smallest);
  const std::string to = roundText (scale.largest);
  const int row = height - line - margin;
  const int left = 2 * margin + letter * int (from.size());
  const int end = left + bar + margin + letter * int (to.size());
  fill (0, row - margin, end + margin, height, {255, 255, 255});
  write (margin, row, from);
  for (int i = 0; i < bar; ++i)
    fill (left + i, row, left + i + 1, row + line, ColorScale::at (float (i) / bar));
  write (left + bar + margin, row, to);
}

void
savePng (const std::string& file, const Image& image, int columns)
{
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = columns;
  header.height = Image::height;
  header.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX (header);
  std::string png (size, '\0');
  if (png_image_write_to_memory (&header,
                                 png.data(),
                                 &size,
                                 0,
                                 image.bytes.data(),
                                 3 * Image::width,
                                 nullptr) == 0)
    throw WorkError (
        file, std::string ("cannot be drawn (") + header.message + "); leave it out");
  png.resize (size);
  writeTextFile (file, png);
}

Image
mapPicture (std::vector<MapShape> shapes)
{
  std::stable_sort (shapes.begin(), shapes.end(), [] (const auto& a, const auto& b) {
    return a.height < b.height;
  });
  const MapScale scale (shapes);
  Image image;
  for (const MapShape& shape : shapes)
    draw (shape, scale, image);
  addScaleBar (scale, image);
  image.addLegend (3);
  return image;
}

} // namespace pcl_ops::apps
