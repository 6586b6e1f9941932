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

  /** \brief Writes capitals, digits and points in black, from the upper left corner. */
  void
  write (int column, int row, const std::string& text);

  /** \brief What the colors of orientations mean, in the right half.
   * \param[in] lines all, or without the gray of no plane */
  void
  addLegend (int lines = 4);

  /** \brief What the colors of a scale mean, in the left half. */
  void
  addLegend (const ColorScale& scale);
};

/** \param[in] columns so many from the left are written */
void
savePng (const std::string& file, const Image& image, int columns = Image::width);

/** \brief A plane as a map shows it. */
struct MapShape {
  std::uint32_t id = 0;
  Orientation orientation = Orientation::Other;
  /** \brief The centroid's z; the higher is drawn above the lower. */
  double height = 0.0;
  /** \brief Outlines and holes, in any order. */
  std::vector<std::vector<Eigen::Vector3d>> rings;
};

/** \brief Two views from above, y upwards: left each plane in its own color over a bar
 * of the scale, right in the color of its orientation class. */
Image
mapPicture (std::vector<MapShape> shapes);

} // namespace pcl_ops::apps
