// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "colors.h"

#include <pcl/common/colors.h>

#include <boost/format.hpp>

#include <algorithm>

namespace pcl_ops::apps {

namespace {

/** \brief PCL's distinct colors without those that look like no plane's gray. */
std::vector<pcl::RGB>
palette ()
{
  constexpr int min_chroma = 50;
  std::vector<pcl::RGB> colors;
  for (std::size_t i = 0; i < pcl::GlasbeyLUT::size(); ++i) {
    const pcl::RGB color = pcl::GlasbeyLUT::at (i);
    const auto [least, most] = std::minmax ({color.r, color.g, color.b});
    if (most - least >= min_chroma)
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

std::string
webColor (const pcl::RGB& color)
{
  return str (boost::format ("#%02x%02x%02x") % int (color.r) % int (color.g) %
              int (color.b));
}

pcl::RGB
colorOf (Orientation orientation)
{
  return orientation == Orientation::Horizontal ? pcl::RGB (64, 160, 72)
         : orientation == Orientation::Vertical ? pcl::RGB (66, 120, 200)
                                                : pcl::RGB (236, 148, 40);
}

void
saveLabelledCloud (const std::string& file,
                   const FileCloud& cloud,
                   const std::vector<std::uint32_t>& labels,
                   const std::vector<float>& distances,
                   bool keeps_color,
                   const std::vector<std::uint32_t>& planes)
{
  const bool has_color = hasField (cloud, "rgb") || hasField (cloud, "rgba");
  saveCloud (file, cloud, [&] (FileCloud& part, std::size_t first) {
    using pcl::PCLPointField;
    const std::uint32_t* const of_part = labels.data() + first;
    if (!distances.empty())
      setField (part, "distance", PCLPointField::FLOAT32, distances.data() + first);
    if (!planes.empty())
      setField (part, "plane", PCLPointField::UINT32, planes.data() + first);
    setField (part, "label", PCLPointField::UINT32, of_part);
    if (keeps_color && has_color)
      return;
    std::vector<pcl::RGB> colors (part.size());
    static_assert (sizeof (colors[0]) == sizeof (float), "PCL's packed color");
    std::transform (of_part, of_part + colors.size(), colors.begin(), colorOfLabel);
    // In front of `rgba`, as PCL's point types look for `rgb` first.
    setField (part, "rgb", PCLPointField::FLOAT32, colors.data(), "rgba");
  });
}

} // namespace pcl_ops::apps
