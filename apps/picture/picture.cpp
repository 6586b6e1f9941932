// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "picture.h"

#include <pcl/common/point_tests.h>

#include "image.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pcl_ops::apps {

namespace {

constexpr float infinitely_far = std::numeric_limits<float>::infinity();

/** \brief Side of a block [pixel], chosen by eye. The image is divided into square
 * blocks, in which dots are counted. */
constexpr int block_side = 16;

/** \brief A point of the cloud in the image. */
struct Dot {
  /** \brief Index of the point in the cloud. */
  pcl::index_t point;
  /** \brief Where it is in the image [pixel]. */
  float column, row;
  /** \brief Distance along the viewing direction [unit of the cloud]. */
  float depth;
};

/** \brief Returns half the side of a dot [pixel] for which the areas of all dots of a
 * block add up to twice the area of the block: dots at random places then cover 86 % of
 * it. */
float
halfSideOf (float dots_in_block)
{
  constexpr float root_of_two = 1.4f; // roughly
  const float pixels_per_dot = block_side * block_side / std::max (dots_in_block, 1.0f);
  return root_of_two * std::sqrt (pixels_per_dot) / 2.0f;
}

/** \brief Returns half the side of each dot [pixel]. A dot is the larger, the fewer
 * dots its block has in front: only those count that are hardly farther than the
 * nearest one.
 * \param[in] width, height of the image [pixel] */
std::vector<float>
halfSidesOf (const std::vector<Dot>& dots, int width, int height)
{
  // Chosen by eye.
  constexpr float max_depth_by_nearest = 1.1f;                // of the dots that count
  constexpr float min_half_side = 0.5f, max_half_side = 5.0f; // [pixel]
  const int columns = width / block_side + 1;
  const int rows = height / block_side + 1;
  Eigen::ArrayXXf nearest = Eigen::ArrayXXf::Constant (columns, rows, infinitely_far);
  Eigen::ArrayXXi counts = Eigen::ArrayXXi::Zero (columns, rows);
  // Returns the element for the block of a dot in an array over all blocks.
  const auto in_block_of = [](auto& blocks, const Dot& dot) -> auto&
  {
    return blocks (static_cast<int> (dot.column) / block_side,
                   static_cast<int> (dot.row) / block_side);
  };
  for (const Dot& dot : dots)
    in_block_of (nearest, dot) = std::min (in_block_of (nearest, dot), dot.depth);
  for (const Dot& dot : dots)
    if (dot.depth <= max_depth_by_nearest * in_block_of (nearest, dot))
      ++in_block_of (counts, dot);
  const auto blocks_with_dots = std::max<Eigen::Index> (1, (counts != 0).count());
  const float mean_count =
      static_cast<float> (counts.sum()) / static_cast<float> (blocks_with_dots);
  // At most twice as large as for the mean number of dots: a block at the rim of a
  // surface has few dots, which else would cover what is beside the surface.
  const float bound =
      std::clamp (2.0f * halfSideOf (mean_count), min_half_side, max_half_side);
  std::vector<float> half_sides;
  for (const Dot& dot : dots) {
    const auto count = static_cast<float> (in_block_of (counts, dot));
    half_sides.push_back (std::clamp (halfSideOf (count), min_half_side, bound));
  }
  return half_sides;
}

/** \brief Sets the pixels of a dot at which no nearer dot is drawn. */
void
drawDot (const Dot& dot, float half_side, Raster& raster)
{
  struct Range {
    Eigen::Index begin, end;
  };
  const auto range_around = [half_side] (float middle, Eigen::Index size) {
    return Range{std::max<Eigen::Index> (std::lround (middle - half_side), 0),
                 std::min<Eigen::Index> (std::lround (middle + half_side), size)};
  };
  const auto [left, right] = range_around (dot.column, raster.points.rows());
  const auto [top, bottom] = range_around (dot.row, raster.points.cols());
  for (Eigen::Index row = top; row < bottom; ++row)
    for (Eigen::Index column = left; column < right; ++column)
      if (dot.depth < raster.depths (column, row)) {
        raster.depths (column, row) = dot.depth;
        raster.points (column, row) = dot.point;
      }
}

/** \brief Calls \p visit (column, row) for every pixel that has eight neighbors. */
template <typename Visit>
void
forEachInnerPixel (const Raster& raster, Visit&& visit)
{
  for (Eigen::Index row = 1; row + 1 < raster.points.cols(); ++row)
    for (Eigen::Index column = 1; column + 1 < raster.points.rows(); ++column)
      visit (column, row);
}

/** \brief If five or more of the eight neighbors of an empty pixel are not empty, fills
 * the pixel with the neighbor of least depth. Surfaces do not grow by this, as a pixel
 * beside a straight edge has only three such neighbors. */
void
closeHoles (Raster& raster)
{
  constexpr int min_filled_neighbors = 5;
  const Raster before = raster;
  forEachInnerPixel (before, [&] (Eigen::Index column, Eigen::Index row) {
    if (before.points (column, row) != Raster::nothing)
      return;
    const auto points = before.points.block<3, 3> (column - 1, row - 1);
    if ((points != Raster::nothing).count() < min_filled_neighbors)
      return;
    const auto depths = before.depths.block<3, 3> (column - 1, row - 1);
    Eigen::Index nearest_column;
    Eigen::Index nearest_row;
    raster.depths (column, row) = depths.minCoeff (&nearest_column, &nearest_row);
    raster.points (column, row) = points (nearest_column, nearest_row);
  });
}

/** \brief Returns the brightness of a plane at a point: 1 if the eye looks along the
 * normal, less at a grazing angle. */
float
brightnessOf (const PlaneSegment& plane, const View& view, const Eigen::Vector3f& point)
{
  constexpr float at_grazing_angle = 0.7f; // the least brightness, chosen by eye
  const Eigen::Vector3f ray = (point - view.eye).normalized();
  const float cosine = std::abs (plane.normal.cast<float>().dot (ray));
  return at_grazing_angle + (1.0f - at_grazing_angle) * cosine;
}

/** \brief Returns the brightness of each pixel, 0 to 1: a pixel is the darker, the more
 * of its neighbors are nearer to the eye, which brings out edges and shape (eye-dome
 * lighting; Boucheny, PhD thesis, Universite Joseph Fourier, 2009). */
Eigen::ArrayXXf
shadeDepths (const Raster& raster)
{
  // Both are chosen by eye: behind a straight edge of another surface, where three
  // neighbors are nearer, the brightness is 0.8, and where all are nearer 0.55.
  constexpr float strength = 12.0f;
  constexpr float max_step = 0.05f; // of the log of depth; larger ones darken no more
  constexpr float neighbors = 8.0f;
  Eigen::ArrayXXf brightness =
      Eigen::ArrayXXf::Ones (raster.depths.rows(), raster.depths.cols());
  forEachInnerPixel (raster, [&] (Eigen::Index column, Eigen::Index row) {
    if (raster.points (column, row) == Raster::nothing)
      return;
    const float depth = raster.depths (column, row);
    float obscurance = 0.0f;
    for (Eigen::Index y = row - 1; y <= row + 1; ++y)
      for (Eigen::Index x = column - 1; x <= column + 1; ++x)
        if (raster.depths (x, y) < depth)
          obscurance += std::min (std::log (depth / raster.depths (x, y)), max_step);
    brightness (column, row) = std::exp (-strength * obscurance / neighbors);
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
  Raster raster;
  raster.points.setConstant (width, height, Raster::nothing);
  raster.depths.setConstant (width, height, infinitely_far);
  const Eigen::Array2f size = Eigen::Array2i (width, height).cast<float>();
  std::vector<Dot> dots;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const auto index = static_cast<pcl::index_t> (i);
    if (!pcl::isXYZFinite (cloud[i]) || !is_shown (index))
      continue;
    const Eigen::Vector3f pixel = view.project (cloud[i].getVector3fMap());
    const bool is_in_front = pixel.z() > 0.0f;
    const bool is_in_image = (pixel.head<2>().array() >= 0.0f).all() &&
                             (pixel.head<2>().array() < size).all();
    if (is_in_front && is_in_image)
      dots.push_back ({index, pixel.x(), pixel.y(), pixel.z()});
  }
  const std::vector<float> half_sides = halfSidesOf (dots, width, height);
  for (std::size_t i = 0; i < dots.size(); ++i)
    drawDot (dots[i], half_sides[i], raster);
  closeHoles (raster);
  return raster;
}

CloudPicture::CloudPicture (const XyzCloud& cloud,
                            const std::vector<std::uint32_t>& labels,
                            const std::vector<PlaneSegment>& planes,
                            const Eigen::Vector3f& up)
: view_ (chooseView (cloud, planes, up, Image::half_width, Image::height))
{
  const auto is_shown = [&] (pcl::index_t point) {
    const std::uint32_t label = labels[static_cast<std::size_t> (point)];
    const Eigen::Vector3f to_eye = view_.eye - cloud[point].getVector3fMap();
    return !view_.hides_backs || label == 0 ||
           planes[label - 1].normal.cast<float>().dot (to_eye) > 0.0f;
  };
  raster_ = drawPoints (cloud, view_, Image::half_width, Image::height, is_shown);
  brightness_ = shadeDepths (raster_);
}

void
CloudPicture::save (const std::string& file,
                    const std::vector<pcl::RGB>& colors,
                    const ColorScale* scale) const
{
  Image image;
  forEachPixel ([&] (int column, int row, pcl::index_t point, float) {
    image.paint (column, row, colors[static_cast<std::size_t> (point)]);
  });
  if (scale != nullptr)
    image.addLegend (*scale);
  savePng (file, image, Image::half_width);
}

void
savePicture (const std::string& file,
             const XyzCloud& cloud,
             const std::vector<std::uint32_t>& labels,
             const std::vector<PlaneSegment>& planes,
             const Eigen::Vector3f& up,
             const std::vector<std::uint32_t>& ids)
{
  const CloudPicture picture (cloud, labels, planes, up);
  Image image;
  picture.forEachPixel ([&] (int column, int row, pcl::index_t point, float light) {
    const std::uint32_t label = labels[static_cast<std::size_t> (point)];
    pcl::RGB of_plane = colorOfLabel (0);
    pcl::RGB of_orientation = of_plane;
    if (label != 0) {
      const PlaneSegment& plane = planes[label - 1];
      of_plane = colorOfLabel (ids.empty() ? label : ids[label - 1]);
      of_orientation = colorOf (plane.orientation);
      light *= brightnessOf (plane, picture.view(), cloud[point].getVector3fMap());
    }
    image.paint (column, row, of_plane, light);
    image.paint (Image::half_width + Image::gap + column, row, of_orientation, light);
  });
  image.addLegend();
  savePng (file, image);
}

} // namespace pcl_ops::apps
