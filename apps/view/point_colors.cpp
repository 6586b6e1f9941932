// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "point_colors.h"

#include <pcl/common/colors.h>
#include <pcl/common/io.h>
#include <pcl/common/point_tests.h>

#include <numbers/quantile.h>
#include <picture/colors.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>

namespace pcl_ops::apps {

namespace {

/** \brief A colour between two: 0 for the first, 1 for the second. */
pcl::RGB
blend (const pcl::RGB& first, const pcl::RGB& second, double share)
{
  const auto part = [share] (std::uint8_t from, std::uint8_t to) {
    return static_cast<std::uint8_t> (std::lround (from + share * (to - from)));
  };
  return {part (first.r, second.r), part (first.g, second.g), part (first.b, second.b)};
}

pcl::RGB
faded (const pcl::RGB& color)
{
  constexpr double faded_share = 0.75;
  constexpr std::uint8_t light_grey = 215;
  return blend (color, {light_grey, light_grey, light_grey}, faded_share);
}

pcl::RGB
shaded (const pcl::RGB& color, const Eigen::Vector3d& normal)
{
  constexpr double darkest = 0.35;
  const Eigen::Vector3d light = Eigen::Vector3d (0.3, 0.55, 0.78).normalized();
  const double dark = darkest * (1.0 - std::abs (normal.dot (light)));
  return blend (color, {0, 0, 0}, dark);
}

/** \brief Where a point's packed colour is, in PCL's order blue, green, red. */
std::optional<pcl::uindex_t>
offsetOfColor (const FileCloud& cloud)
{
  for (const pcl::PCLPointField& field : cloud.points.fields)
    if (field.name == "rgb" || field.name == "rgba")
      return field.offset;
  return std::nullopt;
}

std::vector<pcl::RGB>
colorsAt (pcl::uindex_t offset, const pcl::PCLPointCloud2& cloud)
{
  std::vector<pcl::RGB> colors;
  for (std::size_t i = offset; i + 2 < cloud.data.size(); i += cloud.point_step)
    colors.emplace_back (cloud.data[i + 2], cloud.data[i + 1], cloud.data[i]);
  return colors;
}

std::vector<pcl::RGB>
colorsOfHeight (const XyzCloud& coordinates, const Eigen::Vector3f& up)
{
  // Flying points would leave one colour to all others.
  constexpr double outliers = 0.01;
  std::vector<float> heights;
  for (const pcl::PointXYZ& point : coordinates)
    if (pcl::isXYZFinite (point))
      heights.push_back (point.getVector3fMap().dot (up));
  if (heights.empty())
    return std::vector<pcl::RGB> (coordinates.size(), colorOfLabel (0));
  const float low = quantile (heights, outliers);
  const float high = quantile (heights, 1.0 - outliers);
  const auto most = static_cast<float> (pcl::ViridisLUT::size() - 1);
  std::vector<pcl::RGB> colors;
  for (const pcl::PointXYZ& point : coordinates) {
    const float share =
        high > low ? (point.getVector3fMap().dot (up) - low) / (high - low) : 0.0f;
    const float clamped = share > 0.0f ? std::min (share, 1.0f) : 0.0f; // 0 for NaN
    colors.push_back (
        pcl::ViridisLUT::at (static_cast<std::size_t> (std::lround (clamped * most))));
  }
  return colors;
}

} // namespace

std::vector<pcl::RGB>
inputColors (const FileCloud& cloud,
             const XyzCloud& coordinates,
             const Eigen::Vector3f& up)
{
  const std::optional<pcl::uindex_t> offset = offsetOfColor (cloud);
  return offset ? colorsAt (*offset, cloud.points) : colorsOfHeight (coordinates, up);
}

std::vector<pcl::RGB>
planeColors (const FoundPlanes& found, const ViewState& state)
{
  std::vector<pcl::RGB> colors;
  for (std::size_t i = 0; i < found.planes.size(); ++i) {
    const PlaneSegment& plane = found.planes[i];
    colors.push_back (state.coloring == Coloring::Orientations
                          ? shaded (colorOf (plane.orientation), plane.normal)
                          : colorOfLabel (found.colors[i]));
  }
  return colors;
}

std::vector<pcl::RGB>
pointColors (const FoundPlanes& found,
             const ViewState& state,
             const std::vector<pcl::RGB>& input)
{
  const std::vector<pcl::RGB> planes = planeColors (found, state);
  std::vector<pcl::RGB> colors;
  colors.reserve (found.labels.size());
  for (std::size_t i = 0; i < found.labels.size(); ++i) {
    const std::uint32_t label = found.labels[i];
    const pcl::RGB color = state.coloring == Coloring::Input ? input[i]
                           : label == 0                      ? colorOfLabel (0)
                                                             : planes[label - 1];
    const bool fades = state.selected != 0 && state.selected != label;
    colors.push_back (fades ? faded (color) : color);
  }
  return colors;
}

} // namespace pcl_ops::apps
