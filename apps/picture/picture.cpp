// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "picture.h"

#include "colors.h"
#include "raster.h"
#include "view.h"
#include <cli/errors.h>
#include <io/output_file.h>
#include <png.h>

#include <cmath>
#include <functional>
#include <string>

namespace pcl_ops::apps {

namespace {

constexpr int half_image_width = 960;
constexpr int image_height = 720;
constexpr int gap = 12;
constexpr int image_width = 2 * half_image_width + gap;
constexpr std::uint8_t white = 255;

/** \brief Interleaved red, green and blue, row by row. */
struct Image {
  std::vector<std::uint8_t> bytes =
      std::vector<std::uint8_t> (3U * image_width * image_height, white);

  void
  paint (int column, int row, const pcl::RGB& color, float brightness)
  {
    const std::size_t first = 3U * (static_cast<std::size_t> (row) * image_width +
                                    static_cast<std::size_t> (column));
    const auto dimmed = [brightness] (std::uint8_t part) {
      return static_cast<std::uint8_t> (std::lround (brightness * part));
    };
    bytes[first] = dimmed (color.r);
    bytes[first + 1] = dimmed (color.g);
    bytes[first + 2] = dimmed (color.b);
  }
};

/** \brief Planes seen at a grazing angle are darker than those seen from the front. */
float
facing (const PlaneSegment& plane, const View& view, const Eigen::Vector3f& point)
{
  constexpr float grazing = 0.7f;
  const Eigen::Vector3f ray = (point - view.eye).normalized();
  return grazing + (1.0f - grazing) * std::abs (plane.normal.cast<float>().dot (ray));
}

using ColorOfPoint = std::function<pcl::RGB (pcl::index_t)>;

void
paintHalf (const Raster& raster,
           const std::vector<float>& brightness,
           int first_column,
           const ColorOfPoint& color,
           Image& image)
{
  for (int row = 0; row < raster.height; ++row) {
    for (int column = 0; column < raster.width; ++column) {
      const std::size_t pixel = raster.at (column, row);
      const pcl::index_t point = raster.points[pixel];
      if (point != Raster::nothing)
        image.paint (first_column + column, row, color (point), brightness[pixel]);
    }
  }
}

void
savePng (const std::string& file, const Image& image)
{
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = image_width;
  header.height = image_height;
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

} // namespace

void
savePicture (const std::string& file,
             const XyzCloud& cloud,
             const std::vector<std::uint32_t>& labels,
             const std::vector<PlaneSegment>& planes,
             const Eigen::Vector3f& up,
             const std::vector<std::uint32_t>& ids)
{
  const View view = chooseView (cloud, planes, up, half_image_width, image_height);
  const auto label = [&] (pcl::index_t point) {
    return labels[static_cast<std::size_t> (point)];
  };
  const auto is_shown = [&] (pcl::index_t point) {
    const Eigen::Vector3f to_eye = view.eye - cloud[point].getVector3fMap();
    return !view.hides_backs || label (point) == 0 ||
           planes[label (point) - 1].normal.cast<float>().dot (to_eye) > 0.0f;
  };
  const Raster raster =
      drawPoints (cloud, view, half_image_width, image_height, is_shown);
  std::vector<float> brightness = shadeDepths (raster);
  for (std::size_t pixel = 0; pixel < brightness.size(); ++pixel) {
    const pcl::index_t point = raster.points[pixel];
    if (point != Raster::nothing && label (point) != 0)
      brightness[pixel] *=
          facing (planes[label (point) - 1], view, cloud[point].getVector3fMap());
  }

  Image image;
  const auto plane_color = [&] (pcl::index_t point) {
    const std::uint32_t position = label (point);
    return colorOfLabel (position == 0 || ids.empty() ? position : ids[position - 1]);
  };
  const auto class_color = [&] (pcl::index_t point) {
    return label (point) == 0 ? colorOfLabel (0)
                              : colorOf (planes[label (point) - 1].orientation);
  };
  paintHalf (raster, brightness, 0, plane_color, image);
  paintHalf (raster, brightness, half_image_width + gap, class_color, image);
  savePng (file, image);
}

} // namespace pcl_ops::apps
