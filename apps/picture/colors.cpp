// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "colors.h"

#include <pcl/common/colors.h>

#include <io/cloud_fields.h>

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
                   FileCloud cloud,
                   const std::vector<std::uint32_t>& labels,
                   bool keeps_color)
{
  setLabels (cloud, labels);
  if (!keeps_color || !(hasField (cloud, "rgb") || hasField (cloud, "rgba"))) {
    std::vector<pcl::RGB> colors;
    colors.reserve (labels.size());
    for (const std::uint32_t label : labels)
      colors.push_back (colorOfLabel (label));
    setColors (cloud, colors);
  }
  saveCloud (file, cloud);
}

} // namespace pcl_ops::apps
