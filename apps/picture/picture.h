// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <io/shifted_cloud.h>
#include <pcl_ops/plane.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief Writes a PNG with two views of a cloud side by side: left each plane in its
 * own color, right in the color of its orientation class, with a legend; gray for no
 * plane. Needs no display.
 * \param[in] cloud with the sensor's pose, from whose side it is seen (\ref chooseView)
 * \param[in] labels per point: 0 for no plane, else its position in \p planes plus 1
 * \param[in] up direction against gravity
 * \param[in] ids of the planes, which have their colors by them; empty: 1, 2, ...
 * \throws WorkError if the file cannot be written */
void
savePicture (const std::string& file,
             const XyzCloud& cloud,
             const std::vector<std::uint32_t>& labels,
             const std::vector<PlaneSegment>& planes,
             const Eigen::Vector3f& up,
             const std::vector<std::uint32_t>& ids = {});

} // namespace pcl_ops::apps
