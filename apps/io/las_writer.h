// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief A point in units of the scale, relative to the offset, with its label. */
struct LasPoint {
  std::array<std::int32_t, 3> raw{};
  std::uint32_t label = 0;
};

/** \brief Writes a LAS 1.2 of point data record format 0 in one step, with the labels
 * in its extra bytes. \throws WorkError if it cannot be written */
void
saveLas (const std::string& file,
         const std::vector<LasPoint>& points,
         double scale,
         const Eigen::Vector3d& offset);

} // namespace pcl_ops::apps
