// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "colors.h"

#include <pcl/common/colors.h>

#include <io/cloud_file.h>

#include <algorithm>
#include <vector>

namespace pcl_ops::apps {

namespace {

/** \brief PCL's distinct colors without those that could be taken for no plane's gray.
 */
std::vector<pcl::RGB>
palette ()
{
  constexpr int least_chroma = 50;
  std::vector<pcl::RGB> colors;
  for (std::size_t i = 0; i < pcl::GlasbeyLUT::size(); ++i) {
    const pcl::RGB color = pcl::GlasbeyLUT::at (i);
    const auto [least, most] = std::minmax ({color.r, color.g, color.b});
    if (most - least >= least_chroma)
      colors.push_back (color);
  }
  return colors;
}

template <typename T>
std::vector<T>
slice (const std::vector<T>& values, std::size_t first, std::size_t count)
{
  const auto begin = values.begin() + static_cast<std::ptrdiff_t> (first);
  return {begin, begin + static_cast<std::ptrdiff_t> (count)};
}

} // namespace

pcl::RGB
colorOfLabel (std::uint32_t label)
{
  constexpr std::uint8_t gray = 128;
  static const std::vector<pcl::RGB> colors = palette();
  if (label == 0)
    return {gray, gray, gray};
  return colors[(label - 1) % colors.size()];
}

pcl::RGB
colorOf (Orientation orientation)
{
  switch (orientation) {
  case Orientation::Horizontal:
    return {64, 160, 72};
  case Orientation::Vertical:
    return {66, 120, 200};
  default:
    return {236, 148, 40};
  }
}

void
saveLabelledCloud (const std::string& file,
                   const FileCloud& cloud,
                   const std::vector<std::uint32_t>& labels,
                   const std::vector<float>& distances,
                   bool keeps_color)
{
  const bool has_color = hasField (cloud, "rgb") || hasField (cloud, "rgba");
  saveCloud (file, cloud, [&] (FileCloud& part, std::size_t first) {
    const std::vector<std::uint32_t> of_part = slice (labels, first, part.size());
    if (!distances.empty())
      setDistances (part, slice (distances, first, part.size()));
    setLabels (part, of_part);
    if (keeps_color && has_color)
      return;
    std::vector<pcl::RGB> colors (of_part.size());
    std::transform (of_part.begin(), of_part.end(), colors.begin(), colorOfLabel);
    setColors (part, colors);
  });
}

} // namespace pcl_ops::apps
