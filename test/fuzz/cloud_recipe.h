// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/pcl_base.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include "byte_reader.h"

namespace pcl_ops::fuzz {

/** \brief A cloud and which of its points to use. */
struct FuzzedCloud {
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud;
  /** \brief None: the whole cloud. May be outside of it, double, or without order. */
  pcl::IndicesPtr indices;
};

/** \brief Up to some 4,000 points as bytes say: planes, lines, balls, lattices, dust,
 * equal points, any bits as floats, points far away, not finite ones, all of it shrunk,
 * magnified or moved off. Bytes that were points themselves would hardly ever lie on a
 * plane. */
FuzzedCloud
cloudFrom (ByteReader& bytes);

} // namespace pcl_ops::fuzz
