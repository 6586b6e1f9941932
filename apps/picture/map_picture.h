// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "image.h"
#include <pcl_ops/orientation.h>

#include <cstdint>
#include <vector>

namespace pcl_ops::apps {

/** \brief A plane as a map shows it. */
struct MapShape {
  std::uint32_t id = 0;
  Orientation orientation = Orientation::Other;
  /** \brief Whose z is drawn above that of others: the centroid's. */
  double height = 0.0;
  /** \brief Outlines and holes, in any order. */
  std::vector<std::vector<Eigen::Vector3d>> rings;
};

/** \brief Two views from above, y upwards: left each plane in its own color over a bar
 * of the scale, right in the color of its orientation class. */
Image
mapPicture (std::vector<MapShape> shapes);

} // namespace pcl_ops::apps
