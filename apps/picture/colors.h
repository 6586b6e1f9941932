// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/point_types.h>

#include <io/cloud_file.h>
#include <pcl_ops/orientation.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief Returns gray for 0, else one of a long palette of distinct colors, which
 * repeats. */
pcl::RGB
colorOfLabel (std::uint32_t label);

/** \brief Returns the color as HTML writes it, "#ff8000". */
std::string
webColor (const pcl::RGB& color);

/** \brief Returns green for horizontal, blue for vertical, else orange. */
pcl::RGB
colorOf (Orientation orientation);

/** \brief Logarithmic color scale for positive values, as lengths: viridis, from dark
 * blue to yellow. Its ends are 1, 2 or 5 times a power of ten; at most 2 % of the
 * values are below and 2 % above them. */
class ColorScale {
public:
  /** \param[in] values ignored unless positive and finite */
  explicit ColorScale (const std::vector<float>& values);

  /** \brief Returns the color of a value: gray for NaN; that of the nearer end for
   * values beyond the scale. */
  pcl::RGB
  operator() (float value) const;

  /** \brief Returns the color at a share of the scale, 0 (smallest) to 1 (largest). */
  static pcl::RGB
  at (float share);

  /** \brief The ends of the scale. */
  double smallest = 1.0, largest = 1.0;
};

/** \brief Writes a .pcd or .ply with a label and a color for each point.
 * \param[in] distances per point, for a field "distance"; empty: no field
 * \param[in] keeps_color whether the input's colors stay, if it has any
 * \param[in] planes per point, for a field "plane"; empty: no field */
void
saveLabelledCloud (const std::string& file,
                   const FileCloud& cloud,
                   const std::vector<std::uint32_t>& labels,
                   const std::vector<float>& distances,
                   bool keeps_color,
                   const std::vector<std::uint32_t>& planes = {});

} // namespace pcl_ops::apps
