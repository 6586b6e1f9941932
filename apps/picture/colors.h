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

/** \brief Returns gray for 0, else one of a long palette of distinct colors; behind its
 * end the palette begins again. */
pcl::RGB
colorOfLabel (std::uint32_t label);

/** \brief Returns a color as HTML has it: "#ff8000". */
std::string
webColor (const pcl::RGB& color);

/** \brief Returns green for Horizontal, blue for Vertical, orange for Other. */
pcl::RGB
colorOf (Orientation orientation);

/** \brief Logarithmic color scale for positive values, as lengths: viridis, from dark
 * blue to yellow. Both ends are 1, 2 or 5 times a power of ten. At most 2 % of the
 * values are below the lower end, and at most 2 % above the upper end. */
class ColorScale {
public:
  /** \brief Makes a scale for values; from 1 to 1 if there are none.
   * \param[in] values only positive finite ones count */
  explicit ColorScale (const std::vector<float>& values);

  /** \brief Returns the color of a value: gray for NaN; for a value beyond an end the
   * color of this end. */
  pcl::RGB
  operator() (float value) const;

  /** \brief Returns the color at a position on the scale, from 0 (lower end) to 1
   * (upper end). */
  static pcl::RGB
  at (float position);

  /** \brief The values at the ends of the scale. */
  double smallest = 1.0, largest = 1.0;
};

/** \brief Writes a cloud as .pcd or .ply with a field "label" and the color of its
 * label for each point.
 * \param[in] labels one for each point
 * \param[in] distances one for each point, for a field "distance"; empty: no such field
 * \param[in] keeps_color whether the colors of the cloud are kept, if it has any, in
 * place of those of the labels
 * \param[in] planes one for each point, for a field "plane"; empty: no such field */
void
saveLabeledCloud (const std::string& file,
                  const FileCloud& cloud,
                  const std::vector<std::uint32_t>& labels,
                  const std::vector<float>& distances,
                  bool keeps_color,
                  const std::vector<std::uint32_t>& planes = {});

} // namespace pcl_ops::apps
