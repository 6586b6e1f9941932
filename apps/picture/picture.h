// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/types.h>

#include <Eigen/Core>

#include "view.h"
#include <io/shifted_cloud.h>
#include <pcl_ops/plane.h>

#include <cstdint>
#include <functional>
#include <string>

namespace pcl_ops::apps {

/** \brief Which point each pixel of an image, by column and row, shows, and how far
 * away it is. */
struct Raster {
  static constexpr pcl::index_t nothing = -1;

  /** \brief \ref nothing where no point is seen. */
  Eigen::Array<pcl::index_t, Eigen::Dynamic, Eigen::Dynamic> points;
  /** \brief Along the viewing direction; infinite where no point is seen. */
  Eigen::ArrayXXf depths;
};

/** \brief Draws points as squares just large enough to close the gaps between them, the
 * nearest in front; NaN points never are. */
Raster
drawPoints (const XyzCloud& cloud,
            const View& view,
            int width,
            int height,
            const std::function<bool (pcl::index_t)>& is_shown);

/** \brief Writes a PNG with two pictures of a cloud (\ref chooseView): left each plane
 * in its own color, right in that of its orientation, with a legend; gray for no plane.
 * \param[in] labels per point: 0 for no plane, else its position in \p planes plus 1
 * \param[in] up direction against gravity
 * \param[in] ids of the planes, which have their colors by them; empty: 1, 2, ... */
void
savePicture (const std::string& file,
             const XyzCloud& cloud,
             const std::vector<std::uint32_t>& labels,
             const std::vector<PlaneSegment>& planes,
             const Eigen::Vector3f& up,
             const std::vector<std::uint32_t>& ids = {});

} // namespace pcl_ops::apps
