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

/** \brief Two pictures of \ref half_width side by side, white at first. */
struct Image {
  static constexpr int half_width = 960;
  static constexpr int height = 720;
  static constexpr int gap = 12;
  static constexpr int legend_height = 100;
  static constexpr int width = 2 * half_width + gap;

  /** \brief Interleaved red, green and blue, row by row. */
  std::vector<std::uint8_t> bytes =
      std::vector<std::uint8_t> (3U * width * height, 255U);

  void
  paint (int column, int row, const pcl::RGB& color, float brightness = 1.0f);

  void
  fill (int column, int row, int last_column, int last_row, const pcl::RGB& color);

  /** \brief Writes text in black from its upper left corner. It has the letters of the
   * legends and of round numbers; others are blank. */
  void
  write (int column, int row, const std::string& text);

  /** \brief Draws the legend of the orientation colors into the right half.
   * \param[in] lines 4, or 3 without the gray of no plane */
  void
  addLegend (int lines = 4);

  /** \brief Draws the legend of a color scale into the left half. */
  void
  addLegend (const ColorScale& scale);
};

/** \param[in] columns how many columns are written, from the left */
void
savePng (const std::string& file, const Image& image, int columns = Image::width);

/** \brief A plane as a map shows it. */
struct MapShape {
  std::uint32_t id = 0;
  Orientation orientation = Orientation::Other;
  /** \brief z of the centroid; higher planes are drawn over lower ones. */
  double height = 0.0;
  /** \brief Outlines and holes, in any order. */
  std::vector<std::vector<Eigen::Vector3d>> rings;
};

/** \brief Two views from above, y upwards: left each plane in its own color and a scale
 * bar, right each plane in the color of its orientation class. */
Image
mapPicture (std::vector<MapShape> shapes);

} // namespace pcl_ops::apps
