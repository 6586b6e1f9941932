// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "colors.h"

#include <pcl/common/colors.h>

#include <boost/format.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace pcl_ops::apps {

namespace {

/** \brief Returns PCL's distinct colors without grayish ones, as gray means no plane.
 */
std::vector<pcl::RGB>
palette ()
{
  // The largest minus the smallest of red, green and blue, which are 0 to 255; chosen
  // by eye.
  constexpr int min_chroma = 50;
  std::vector<pcl::RGB> colors;
  for (std::size_t i = 0; i < pcl::GlasbeyLUT::size(); ++i) {
    const pcl::RGB color = pcl::GlasbeyLUT::at (i);
    const auto [smallest, largest] = std::minmax ({color.r, color.g, color.b});
    if (largest - smallest >= min_chroma)
      colors.push_back (color);
  }
  return colors;
}

/** \brief Returns the largest number that is 1, 2 or 5 times a power of ten and not
 * above \p number, except for rounding. */
double
roundedDown (double number)
{
  constexpr double rounding = 1e-6; // relative to the number
  const double bound = number * (1.0 + rounding);
  const double power = std::pow (10.0, std::floor (std::log10 (bound)));
  for (const double factor : {5.0, 2.0})
    if (factor * power <= bound)
      return factor * power;
  return power;
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

ColorScale::ColorScale (const std::vector<float>& values)
{
  constexpr double share_beyond_end = 0.02; // of the values, at each end
  std::vector<float> sorted;
  std::copy_if (values.begin(),
                values.end(),
                std::back_inserter (sorted),
                [] (float value) { return value > 0.0f && std::isfinite (value); });
  if (sorted.empty())
    return;
  std::sort (sorted.begin(), sorted.end());
  const auto last_index = static_cast<double> (sorted.size() - 1);
  const float low = sorted[std::size_t (share_beyond_end * last_index)];
  const float high = sorted[std::size_t ((1.0 - share_beyond_end) * last_index)];
  smallest = roundedDown (low);
  // Rounding the inverse down rounds the number up.
  largest = 1.0 / roundedDown (1.0 / double (high));
}

pcl::RGB
ColorScale::operator() (float value) const
{
  if (std::isnan (value))
    return colorOfLabel (0);
  if (!(value > smallest))
    return at (0.0f);
  if (value >= largest)
    return at (1.0f);
  return at (float (std::log (value / smallest) / std::log (largest / smallest)));
}

pcl::RGB
ColorScale::at (float position)
{
  constexpr float last_index = 255.0f;
  return pcl::ViridisLUT::at (
      std::size_t (last_index * std::clamp (position, 0.0f, 1.0f)));
}

void
saveLabeledCloud (const std::string& file,
                  const FileCloud& cloud,
                  const std::vector<std::uint32_t>& labels,
                  const std::vector<float>& distances,
                  bool keeps_color,
                  const std::vector<std::uint32_t>& planes)
{
  const bool has_color = hasField (cloud, "rgb") || hasField (cloud, "rgba");
  saveCloud (file, cloud, [&] (FileCloud& part, std::size_t first) {
    using pcl::PCLPointField;
    const std::uint32_t* const part_labels = labels.data() + first;
    if (!distances.empty())
      setField (part, "distance", PCLPointField::FLOAT32, distances.data() + first);
    if (!planes.empty())
      setField (part, "plane", PCLPointField::UINT32, planes.data() + first);
    setField (part, "label", PCLPointField::UINT32, part_labels);
    if (keeps_color && has_color)
      return;
    std::vector<pcl::RGB> colors (part.size());
    static_assert (sizeof (colors[0]) == sizeof (float), "PCL's packed color");
    std::transform (
        part_labels, part_labels + colors.size(), colors.begin(), colorOfLabel);
    // In front of `rgba`: a point type of PCL takes the first field named `rgb` or
    // `rgba`.
    setField (part, "rgb", PCLPointField::FLOAT32, colors.data(), "rgba");
  });
}

} // namespace pcl_ops::apps
