// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "point_colors.h"

#include <pcl/common/colors.h>
#include <pcl/common/io.h>
#include <pcl/common/point_tests.h>

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
  constexpr double kFaded = 0.75;
  constexpr std::uint8_t kLightGrey = 215;
  return blend (color, {kLightGrey, kLightGrey, kLightGrey}, kFaded);
}

pcl::RGB
shaded (const pcl::RGB& color, const Eigen::Vector3d& normal)
{
  constexpr double kDarkest = 0.35;
  const Eigen::Vector3d light = Eigen::Vector3d (0.3, 0.55, 0.78).normalized();
  const double dark = kDarkest * (1.0 - std::abs (normal.dot (light)));
  return blend (color, {0, 0, 0}, dark);
}

/** \brief Where a point's packed colour is, in PCL's order blue, green, red. */
std::optional<pcl::uindex_t>
offsetOfColor (const Cloud& cloud)
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
colorsOfHeight (const pcl::PointCloud<pcl::PointXYZ>& positions,
                const Eigen::Vector3f& up)
{
  // Flying points would leave one colour to all others.
  constexpr double kOutliers = 0.01;
  std::vector<float> heights;
  for (const pcl::PointXYZ& point : positions)
    if (pcl::isXYZFinite (point))
      heights.push_back (point.getVector3fMap().dot (up));
  if (heights.empty())
    return std::vector<pcl::RGB> (positions.size(), colorOfLabel (0));
  std::sort (heights.begin(), heights.end());
  const double last = static_cast<double> (heights.size() - 1);
  const float low = heights[static_cast<std::size_t> (kOutliers * last)];
  const float high = heights[static_cast<std::size_t> ((1.0 - kOutliers) * last)];
  const auto most = static_cast<float> (pcl::ViridisLUT::size() - 1);
  std::vector<pcl::RGB> colors;
  for (const pcl::PointXYZ& point : positions) {
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
inputColors (const Cloud& cloud,
             const pcl::PointCloud<pcl::PointXYZ>& positions,
             const Eigen::Vector3f& up)
{
  const std::optional<pcl::uindex_t> offset = offsetOfColor (cloud);
  return offset ? colorsAt (*offset, cloud.points) : colorsOfHeight (positions, up);
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
