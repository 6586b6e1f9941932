// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/point_types.h>

#include <Eigen/Core>

#include "colors.h"
#include <pcl_ops/orientation.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief Two pictures side by side, each \ref half_width wide, with a \ref gap between
 * them; white at first. Lengths are in pixels, chosen by eye; columns count from the
 * left, rows from the top. */
struct Image {
  static constexpr int half_width = 960;
  static constexpr int height = 720;
  static constexpr int gap = 12;
  static constexpr int legend_height = 100;
  static constexpr int width = 2 * half_width + gap;

  /** \brief Red, green and blue of each pixel, row by row. */
  std::vector<std::uint8_t> bytes =
      std::vector<std::uint8_t> (3U * width * height, 255U);

  // What the following functions draw must lie inside the image: they do not check it.

  /** \brief Sets a pixel.
   * \param[in] brightness factor of the color, 0 (black) to 1 */
  void
  paint (int column, int row, const pcl::RGB& color, float brightness = 1.0f);

  /** \brief Fills a rectangle: the columns from \p left to \p right - 1, in the rows
   * from \p top to \p bottom - 1. */
  void
  fill (int left, int top, int right, int bottom, const pcl::RGB& color);

  /** \brief Writes text in black. Only letters of the legends, and of numbers that are
   * 1, 2 or 5 times a power of ten, are drawn; others are left blank.
   * \param[in] left, top column and row of the upper left corner of the text */
  void
  write (int left, int top, const std::string& text);

  /** \brief Draws the legend of the colors of orientations into the right half.
   * \param[in] lines number of its lines: 4, or 3 to leave out that of no plane,
   * gray */
  void
  addLegend (int lines = 4);

  /** \brief Draws the legend of a color scale into the left half. */
  void
  addLegend (const ColorScale& scale);
};

/** \brief Writes an image as a PNG.
 * \param[in] columns number of columns to write, from the left */
void
savePng (const std::string& file, const Image& image, int columns = Image::width);

/** \brief A plane as a map shows it. */
struct MapShape {
  /** \brief Id of the plane, which decides on its color in the left half (\ref
   * colorOfLabel). */
  std::uint32_t id = 0;
  Orientation orientation = Orientation::Other;
  /** \brief z of the centroid. Higher planes are drawn over lower ones. */
  double height = 0.0;
  /** \brief Outlines and holes, in any order, each with its corners in order. */
  std::vector<std::vector<Eigen::Vector3d>> rings;
};

/** \brief Draws planes twice as seen from above, with y upwards in the image: left each
 * plane in its own color, and a scale bar; right each plane in the color of its
 * orientation, and a legend. Planes with coordinates beyond the range of float, as a
 * damaged list of planes may have them, are left out. */
Image
mapPicture (std::vector<MapShape> shapes);

} // namespace pcl_ops::apps
