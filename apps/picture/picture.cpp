// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "picture.h"

#include "colors.h"
#include "image.h"
#include "raster.h"
#include "view.h"

#include <cmath>
#include <functional>
#include <string>

namespace pcl_ops::apps {

namespace {

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

} // namespace

void
savePicture (const std::string& file,
             const XyzCloud& cloud,
             const std::vector<std::uint32_t>& labels,
             const std::vector<PlaneSegment>& planes,
             const Eigen::Vector3f& up,
             const std::vector<std::uint32_t>& ids)
{
  const View view = chooseView (cloud, planes, up, Image::half_width, Image::height);
  const auto label = [&] (pcl::index_t point) {
    return labels[static_cast<std::size_t> (point)];
  };
  const auto is_shown = [&] (pcl::index_t point) {
    const Eigen::Vector3f to_eye = view.eye - cloud[point].getVector3fMap();
    return !view.hides_backs || label (point) == 0 ||
           planes[label (point) - 1].normal.cast<float>().dot (to_eye) > 0.0f;
  };
  const Raster raster =
      drawPoints (cloud, view, Image::half_width, Image::height, is_shown);
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
  paintHalf (raster, brightness, Image::half_width + Image::gap, class_color, image);
  image.addLegend();
  savePng (file, image);
}

} // namespace pcl_ops::apps
