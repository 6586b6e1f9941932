// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "map_picture.h"

#include <Eigen/Geometry>

#include "colors.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

namespace pcl_ops::apps {

namespace {

constexpr int margin = 12;

/** \brief From the frame of the map to columns and rows. */
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

/** \brief Fills its rings by the even-odd rule, row by row: holes and parts alike. */
void
draw (const MapShape& shape, const MapScale& scale, Image& image)
{
  const auto row_of = [] (double y) { return static_cast<int> (std::ceil (y - 0.5)); };
  std::map<int, std::vector<double>> crossings; // of the middles of rows
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

/** \brief A bar of 1, 2 or 5 times a power of ten, at most a third of the width. */
void
addScaleBar (const MapScale& scale, Image& image)
{
  const double longest = Image::half_width / 3.0 / scale.per_unit;
  const double power = std::pow (10.0, std::floor (std::log10 (longest)));
  double length = power;
  for (const double factor : {2.0, 5.0})
    if (factor * power <= longest)
      length = factor * power;
  std::ostringstream text;
  text << std::fixed;
  text.precision (length < 1.0 ? int (std::ceil (-std::log10 (length))) : 0);
  text << length;
  constexpr int bar = 6, row = Image::height - 3 * margin;
  const int end = margin + int (std::lround (length * scale.per_unit));
  image.fill (margin, row, end, row + bar, {0, 0, 0});
  image.write (end + margin, row - bar, text.str());
}

} // namespace

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
