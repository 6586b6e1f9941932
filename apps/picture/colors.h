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

/** \brief Gray for 0, a distinct one per plane. */
pcl::RGB
colorOfLabel (std::uint32_t label);

/** \brief As "#ff8000". */
std::string
webColor (const pcl::RGB& color);

pcl::RGB
colorOf (Orientation orientation);

/** \brief Colors for lengths and the like, by their logarithm, from dark blue to
 * yellow. It ends at 1, 2 or 5 times a power of ten beyond all but the 2 % of smallest
 * and of largest values. */
class ColorScale {
public:
  /** \param[in] values those that are not above 0, or NaN, do not count */
  explicit ColorScale (const std::vector<float>& values);

  /** \brief Gray for NaN. */
  pcl::RGB
  operator() (float value) const;

  /** \brief At a share of the way from the smallest to the largest value, 0 to 1. */
  static pcl::RGB
  at (float share);

  double smallest = 1.0;
  double largest = 1.0;
};

/** \brief Writes a .pcd or .ply with a label and a color for each point.
 * \param[in] distances per point, for a field of that name, or none
 * \param[in] keeps_color whether the input's colors stay, where it has any
 * \param[in] planes per point, for a field "plane", or none */
void
saveLabelledCloud (const std::string& file,
                   const FileCloud& cloud,
                   const std::vector<std::uint32_t>& labels,
                   const std::vector<float>& distances,
                   bool keeps_color,
                   const std::vector<std::uint32_t>& planes = {});

} // namespace pcl_ops::apps
