// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/point_types.h>

#include <pcl_ops/orientation.h>

#include <cstdint>

namespace pcl_ops::apps {

/** \brief Color of a point by its label: gray for 0, a distinct one per plane.
 */
pcl::RGB
colorOfLabel (std::uint32_t label);

/** \brief Color of a plane's orientation class. */
pcl::RGB
colorOf (Orientation orientation);

} // namespace pcl_ops::apps
