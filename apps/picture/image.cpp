// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "image.h"

#include <Eigen/Geometry>

#include <cli/errors.h>
#include <io/output_file.h>
#include <png.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <sstream>
#include <string_view>

namespace pcl_ops::apps {

namespace {

pcl::RGB
black ()
{
  return {0, 0, 0};
}

pcl::RGB
white ()
{
  return {255, 255, 255};
}

/** \brief Side of a dot, of which letters are made [pixel]. */
constexpr int dot = 3;

/** \brief Width and height of a letter [dots]. */
constexpr int letter_columns = 3, letter_rows = 5;

/** \brief Distance from the left end of a letter to that of the next one [dots]. */
constexpr int letter_step = letter_columns + 1;

/** \brief The letters that can be written. */
constexpr std::string_view letters = "0125.ACEHILNOPRTVZ";

/** \brief The five rows of dots of each of these letters, from the top, one letter
 * after the other. An octal digit is a row; its three bits are the dots, the highest
 * bit is the left dot. */
constexpr std::string_view rows_of_letters =
    "755572622771747747170000225755344437464755755722274444765555255526564465655"
    "722225555271247";

/** \brief Free space around maps, scale bars and color scales [pixel]. Like other
 * lengths here it is chosen by eye. */
constexpr int margin = 12;

/** \brief Whether all coordinates are in the range of float: sizes of shapes beyond it
 * could overflow. */
bool
isDrawable (const MapShape& shape)
{
  constexpr double max_coordinate = std::numeric_limits<float>::max();
  for (const auto& ring : shape.rings)
    for (const Eigen::Vector3d& corner : ring)
      if (!(corner.array().abs() <= max_coordinate).all())
        return false;
  return true;
}

/** \brief Transforms x and y of a map to columns and rows of the left half of an image.
 */
struct MapScale {
  /** \brief Sets the largest scale at which all shapes fit into half an image, except
   * for its legend and margins. */
  explicit MapScale (const std::vector<MapShape>& shapes)
  {
    Eigen::AlignedBox2d box;
    for (const MapShape& shape : shapes)
      for (const auto& ring : shape.rings)
        for (const Eigen::Vector3d& corner : ring)
          box.extend (corner.head<2>());
    if (box.isEmpty())
      return;
    const Eigen::Array2d free_space (Image::half_width - 2 * margin,
                                     Image::height - Image::legend_height - 2 * margin);
    const double fitting = (free_space / box.sizes().array()).minCoeff();
    pixels_per_unit = std::isfinite (fitting) ? fitting : 1.0;
    upper_left = {box.min().x(), box.max().y()};
  }

  /** \brief Returns the column and the row of a corner. */
  Eigen::Vector2d
  pixel (const Eigen::Vector3d& corner) const
  {
    return {margin + pixels_per_unit * (corner.x() - upper_left.x()),
            margin + pixels_per_unit * (upper_left.y() - corner.y())};
  }

  double pixels_per_unit = 1.0;
  /** \brief Smallest x and largest y of all shapes. */
  Eigen::Vector2d upper_left = Eigen::Vector2d::Zero();
};

/** \brief By row of the image: the columns at which the rings of a shape cross the
 * horizontal line through the middle of the row. */
using Crossings = std::map<int, std::vector<double>>;

Crossings
crossingsOf (const MapShape& shape, const MapScale& scale)
{
  // The first row whose middle is at or below y.
  const auto first_row_from = [] (double y) {
    return static_cast<int> (std::ceil (y - 0.5));
  };
  Crossings crossings;
  for (const auto& ring : shape.rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      Eigen::Vector2d a = scale.pixel (ring[i]);
      Eigen::Vector2d b = scale.pixel (ring[(i + 1) % ring.size()]);
      if (a.y() > b.y())
        a.swap (b);
      for (int row = first_row_from (a.y()); row < first_row_from (b.y()); ++row)
        crossings[row].push_back (a.x() + (row + 0.5 - a.y()) / (b.y() - a.y()) *
                                              (b.x() - a.x()));
    }
  return crossings;
}

/** \brief Fills a shape in both halves: row by row what is inside an odd number of its
 * rings. */
void
draw (const MapShape& shape, const MapScale& scale, Image& image)
{
  constexpr int to_right_half = Image::half_width + Image::gap;
  for (auto& [row, columns] : crossingsOf (shape, scale)) {
    std::sort (columns.begin(), columns.end());
    for (std::size_t i = 0; i + 1 < columns.size(); i += 2) {
      const int left = int (columns[i]);
      // At least one pixel, so that walls, which are lines from above, are visible.
      const int right = std::max (left + 1, int (columns[i + 1]));
      image.fill (left, row, right, row + 1, colorOfLabel (shape.id));
      image.fill (left + to_right_half,
                  row,
                  right + to_right_half,
                  row + 1,
                  colorOf (shape.orientation));
    }
  }
}

/** \brief Returns a number that is 1, 2 or 5 times a power of ten as text without an
 * exponent. */
std::string
roundText (double number)
{
  const int decimals = number < 1.0 ? int (std::ceil (-std::log10 (number))) : 0;
  std::ostringstream text;
  text << std::fixed;
  text.precision (decimals);
  text << number;
  return text.str();
}

/** \brief Draws a scale bar whose length is 1, 2 or 5 times a power of ten, and in the
 * image at most a third of the left half. */
void
addScaleBar (const MapScale& scale, Image& image)
{
  const double max_length = Image::half_width / 3.0 / scale.pixels_per_unit;
  const double power = std::pow (10.0, std::floor (std::log10 (max_length)));
  double length = power;
  for (const double factor : {2.0, 5.0})
    if (factor * power <= max_length)
      length = factor * power;
  constexpr int bar_height = 6;
  constexpr int top = Image::height - 3 * margin;
  const int right = margin + int (std::lround (length * scale.pixels_per_unit));
  image.fill (margin, top, right, top + bar_height, black());
  image.write (right + margin, top - bar_height, roundText (length));
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
Image::fill (int left, int top, int right, int bottom, const pcl::RGB& color)
{
  for (int row = top; row < bottom; ++row)
    for (int column = left; column < right; ++column)
      paint (column, row, color);
}

void
Image::write (int left, int top, const std::string& text)
{
  for (const char letter : text) {
    const std::size_t index = letters.find (letter);
    const bool is_blank = index == std::string_view::npos;
    for (int row = 0; row < letter_rows && !is_blank; ++row) {
      const char dots = rows_of_letters[letter_rows * index + std::size_t (row)];
      for (int column = 0; column < letter_columns; ++column)
        // The lowest three bits of an ASCII digit are those of its value.
        if ((dots >> (letter_columns - 1 - column) & 1) != 0) {
          const int x = left + dot * column;
          const int y = top + dot * row;
          fill (x, y, x + dot, y + dot, black());
        }
    }
    left += dot * letter_step;
  }
}

void
Image::addLegend (int lines)
{
  constexpr int line_height = 8 * dot;
  constexpr int box_side = letter_rows * dot;        // of the square with the color
  constexpr int text_width = 11 * letter_step * dot; // 11 letters: HORIZONTAL, a blank
  struct Entry {
    const char* text;
    pcl::RGB color;
  };
  const Entry entries[] = {{"HORIZONTAL", colorOf (Orientation::Horizontal)},
                           {"VERTICAL", colorOf (Orientation::Vertical)},
                           {"OTHER", colorOf (Orientation::Other)},
                           {"NO PLANE", colorOfLabel (0)}};
  const int left = half_width + gap;
  const int text_left = left + box_side + 3 * dot;
  fill (left, height - legend_height, text_left + text_width, height, white());
  int top = height - lines * line_height;
  for (int i = 0; i < lines; ++i, top += line_height) {
    fill (left + dot, top, left + dot + box_side, top + box_side, entries[i].color);
    write (text_left, top, entries[i].text);
  }
}

void
Image::addLegend (const ColorScale& scale)
{
  constexpr int letter_width = letter_step * dot;
  constexpr int bar_height = letter_rows * dot;
  constexpr int bar_width = 256;
  const std::string smallest = roundText (scale.smallest);
  const std::string largest = roundText (scale.largest);
  const int top = height - bar_height - margin;
  const int bar_left = 2 * margin + letter_width * int (smallest.size());
  const int largest_left = bar_left + bar_width + margin;
  const int right = largest_left + letter_width * int (largest.size());
  fill (0, top - margin, right + margin, height, white());
  write (margin, top, smallest);
  for (int i = 0; i < bar_width; ++i) {
    const int left = bar_left + i;
    const pcl::RGB color = ColorScale::at (float (i) / bar_width);
    fill (left, top, left + 1, top + bar_height, color);
  }
  write (largest_left, top, largest);
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
  constexpr int keep_8_bits = 0;               // 1 would convert 16 bits per color
  constexpr int row_stride = 3 * Image::width; // [bytes]
  const int succeeded = png_image_write_to_memory (
      &header, png.data(), &size, keep_8_bits, image.bytes.data(), row_stride, nullptr);
  if (succeeded == 0)
    throw WorkError (
        file, std::string ("cannot be drawn (") + header.message + "); leave it out");
  png.resize (size);
  writeTextFile (file, png);
}

Image
mapPicture (std::vector<MapShape> shapes)
{
  shapes.erase (std::remove_if (shapes.begin(), shapes.end(), std::not_fn (isDrawable)),
                shapes.end());
  std::stable_sort (shapes.begin(), shapes.end(), [] (const auto& a, const auto& b) {
    return a.height < b.height;
  });
  const MapScale scale (shapes);
  Image image;
  for (const MapShape& shape : shapes)
    draw (shape, scale, image);
  addScaleBar (scale, image);
  constexpr int orientations_alone = 3; // no line for NO PLANE
  image.addLegend (orientations_alone);
  return image;
}

} // namespace pcl_ops::apps
