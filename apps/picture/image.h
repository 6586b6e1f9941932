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

/** \brief Two pictures of \ref half_width side by side, with a \ref gap between them,
 * white at first. Lengths, columns and rows are in pixels, from the upper left corner.
 */
struct Image {
  static constexpr int half_width = 960;
  static constexpr int height = 720;
  static constexpr int gap = 12;
  static constexpr int legend_height = 100;
  static constexpr int width = 2 * half_width + gap;

  /** \brief Interleaved red, green and blue, row by row. */
  std::vector<std::uint8_t> bytes =
      std::vector<std::uint8_t> (3U * width * height, 255U);

  /** \brief Sets a pixel, which must be in the image; \ref fill and \ref write leave
   * nothing out, either.
   * \param[in] brightness factor of the color, 0 (black) to 1 */
  void
  paint (int column, int row, const pcl::RGB& color, float brightness = 1.0f);

  /** \brief Fills a rectangle: columns \p left to \p right - 1, rows \p top to
   * \p bottom - 1. */
  void
  fill (int left, int top, int right, int bottom, const pcl::RGB& color);

  /** \brief Writes text in black. There are letters for the legends and for round
   * numbers; others are blank.
   * \param[in] left, top upper left corner of the text */
  void
  write (int left, int top, const std::string& text);

  /** \brief Draws the legend of the orientation colors into the right half.
   * \param[in] lines 4, or 3 without the gray of no plane */
  void
  addLegend (int lines = 4);

  /** \brief Draws the legend of a color scale into the left half. */
  void
  addLegend (const ColorScale& scale);
};

/** \brief Writes an image as a PNG.
 * \param[in] columns how many are written, from the left */
void
savePng (const std::string& file, const Image& image, int columns = Image::width);

/** \brief A plane as a map shows it. */
struct MapShape {
  /** \brief Decides on its own color (\ref colorOfLabel). */
  std::uint32_t id = 0;
  Orientation orientation = Orientation::Other;
  /** \brief z of the centroid; higher planes are drawn over lower ones. */
  double height = 0.0;
  /** \brief Outlines and holes, in any order. */
  std::vector<std::vector<Eigen::Vector3d>> rings;
};

/** \brief Draws two views from above, y upwards: left each plane in its own color and a
 * scale bar, right each plane in the color of its orientation class. */
Image
mapPicture (std::vector<MapShape> shapes);

} // namespace pcl_ops::apps
