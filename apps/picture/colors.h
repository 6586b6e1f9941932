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
