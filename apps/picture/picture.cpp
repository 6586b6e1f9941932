// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "picture.h"

#include <pcl/common/point_tests.h>

#include "colors.h"
#include "image.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace pcl_ops::apps {

namespace {

constexpr float far = std::numeric_limits<float>::infinity();

/** \brief Side of the parts of the image that are looked at as one [pixel]. */
constexpr int part = 16;

struct Dot {
  pcl::index_t point;
  float column, row, depth;
};

/** \brief [pixel] of squares of which so many cover a part of the image twice. */
float
halfSideOf (float dots_in_part)
{
  constexpr float overlap = 1.4f;
  const float pixels_per_dot = part * part / std::max (dots_in_part, 1.0f);
  return overlap * std::sqrt (pixels_per_dot) / 2.0f;
}

/** \brief Of each dot, by how many share its part of the image in the front layer. */
std::vector<float>
halfSidesOf (const std::vector<Dot>& dots, int width, int height)
{
  constexpr float front_layer = 1.1f; // its depth, in units of the nearest
  constexpr float smallest = 0.5f;
  constexpr float largest = 5.0f;
  const int columns = width / part + 1;
  const auto part_of = [columns] (const Dot& dot) {
    return static_cast<std::size_t> (static_cast<int> (dot.row) / part * columns +
                                     static_cast<int> (dot.column) / part);
  };
  const auto parts = static_cast<std::size_t> (columns * (height / part + 1));
  std::vector<float> nearest (parts, far);
  for (const Dot& dot : dots)
    nearest[part_of (dot)] = std::min (nearest[part_of (dot)], dot.depth);
  std::vector<int> counts (parts, 0);
  for (const Dot& dot : dots)
    if (dot.depth <= front_layer * nearest[part_of (dot)])
      ++counts[part_of (dot)];
  const auto used =
      parts - static_cast<std::size_t> (std::count (counts.begin(), counts.end(), 0));
  const auto in_front = std::accumulate (counts.begin(), counts.end(), 0);
  const float mean = static_cast<float> (in_front) /
                     static_cast<float> (std::max<std::size_t> (used, 1));
  const float most = std::clamp (2.0f * halfSideOf (mean), smallest, largest);
  std::vector<float> half_sides;
  for (const Dot& dot : dots)
    half_sides.push_back (std::clamp (
        halfSideOf (static_cast<float> (counts[part_of (dot)])), smallest, most));
  return half_sides;
}

void
drawDot (const Dot& dot, float half_side, Raster& raster)
{
  const auto range = [half_side] (float middle, int end) {
    const float low = middle - half_side, high = middle + half_side;
    return std::make_pair (std::max (static_cast<int> (std::lround (low)), 0),
                           std::min (static_cast<int> (std::lround (high)), end));
  };
  const auto [left, right] = range (dot.column, raster.width);
  const auto [top, bottom] = range (dot.row, raster.height);
  for (int row = top; row < bottom; ++row)
    for (int column = left; column < right; ++column) {
      const std::size_t pixel = raster.at (column, row);
      if (dot.depth < raster.depths[pixel]) {
        raster.depths[pixel] = dot.depth;
        raster.points[pixel] = dot.point;
      }
    }
}

/** \brief Visits every pixel inside the border with the eight around it. */
template <typename Visit>
void
forEachInnerPixel (const Raster& raster, Visit&& visit)
{
  const std::size_t line = raster.at (0, 1);
  for (int row = 1; row + 1 < raster.height; ++row)
    for (int column = 1; column + 1 < raster.width; ++column) {
      const std::size_t i = raster.at (column, row), above = i - line, below = i + line;
      visit (
          i,
          std::array{
              above - 1, above, above + 1, i - 1, i + 1, below - 1, below, below + 1});
    }
}

/** \brief Gives empty pixels that most neighbors surround the nearest of those. */
void
closeHoles (Raster& raster)
{
  constexpr int most = 5;
  const Raster before = raster;
  forEachInnerPixel (before, [&] (std::size_t pixel, const auto& around) {
    if (before.points[pixel] != Raster::nothing)
      return;
    const auto seen = std::count_if (around.begin(), around.end(), [&] (std::size_t i) {
      return before.points[i] != Raster::nothing;
    });
    if (seen < most)
      return;
    const std::size_t nearest =
        *std::min_element (around.begin(), around.end(), [&] (auto a, auto b) {
          return before.depths[a] < before.depths[b];
        });
    raster.points[pixel] = before.points[nearest];
    raster.depths[pixel] = before.depths[nearest];
  });
}

/** \brief Planes seen at a grazing angle are darker than those seen from the front. */
float
facing (const PlaneSegment& plane, const View& view, const Eigen::Vector3f& point)
{
  constexpr float grazing = 0.7f;
  const Eigen::Vector3f ray = (point - view.eye).normalized();
  return grazing + (1.0f - grazing) * std::abs (plane.normal.cast<float>().dot (ray));
}

/** \brief Brightness of each pixel, 0 to 1: pixels behind a near neighbor are darker,
 * which brings out edges and shape (eye-dome lighting; Boucheny, PhD thesis, Universite
 * Joseph Fourier, 2009). */
std::vector<float>
shadeDepths (const Raster& raster)
{
  constexpr float strength = 6.0f;
  constexpr float largest_step = 0.05f; // of the logarithm: farther ones darken no more
  std::vector<float> brightness (raster.points.size(), 1.0f);
  forEachInnerPixel (raster, [&] (std::size_t pixel, const auto& around) {
    if (raster.points[pixel] == Raster::nothing)
      return;
    float obscurance = 0.0f;
    for (const std::size_t neighbor : around)
      if (raster.depths[neighbor] < raster.depths[pixel])
        obscurance += std::min (
            std::log (raster.depths[pixel] / raster.depths[neighbor]), largest_step);
    brightness[pixel] =
        std::exp (-strength * obscurance / static_cast<float> (around.size()) * 2.0f);
  });
  return brightness;
}

} // namespace

Raster
drawPoints (const XyzCloud& cloud,
            const View& view,
            int width,
            int height,
            const std::function<bool (pcl::index_t)>& is_shown)
{
  Raster raster{width, height, {}, {}};
  raster.points.assign (raster.at (0, height), Raster::nothing);
  raster.depths.assign (raster.at (0, height), far);
  const Eigen::Array2f size = Eigen::Array2i (width, height).cast<float>();
  std::vector<Dot> dots;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const auto index = static_cast<pcl::index_t> (i);
    if (!pcl::isXYZFinite (cloud[i]) || !is_shown (index))
      continue;
    const Eigen::Vector3f pixel = view.project (cloud[i].getVector3fMap());
    if (pixel.z() > 0.0f && (pixel.head<2>().array() >= 0.0f).all() &&
        (pixel.head<2>().array() < size).all())
      dots.push_back ({index, pixel.x(), pixel.y(), pixel.z()});
  }
  const std::vector<float> half_sides = halfSidesOf (dots, width, height);
  for (std::size_t i = 0; i < dots.size(); ++i)
    drawDot (dots[i], half_sides[i], raster);
  closeHoles (raster);
  return raster;
}

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
  const std::vector<float> brightness = shadeDepths (raster);
  Image image;
  for (int row = 0; row < raster.height; ++row)
    for (int column = 0; column < raster.width; ++column) {
      const std::size_t pixel = raster.at (column, row);
      const pcl::index_t point = raster.points[pixel];
      if (point == Raster::nothing)
        continue;
      const std::uint32_t position = label (point);
      pcl::RGB by_plane = colorOfLabel (0), by_class = by_plane;
      float light = brightness[pixel];
      if (position != 0) {
        const PlaneSegment& plane = planes[position - 1];
        by_plane = colorOfLabel (ids.empty() ? position : ids[position - 1]);
        by_class = colorOf (plane.orientation);
        light *= facing (plane, view, cloud[point].getVector3fMap());
      }
      image.paint (column, row, by_plane, light);
      image.paint (Image::half_width + Image::gap + column, row, by_class, light);
    }
  image.addLegend();
  savePng (file, image);
}

} // namespace pcl_ops::apps
