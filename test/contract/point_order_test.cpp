// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "presets.h"
#include "scene.h"

#include <numeric>

// A scanner gives points that are next to each other one after the other; a cloud out
// of a filter, or of several scans, is in any order.

namespace {

LabelledScene
furnishedRoom ()
{
  return Scene()
      .floor (4, 3)
      .wall ({0, 0}, {4, 0}, 2.4)
      .wall ({0, 0}, {0, 3}, 2.4)
      .surface ({1, 1, 0.7}, {1.2, 0, 0}, {0, 0.8, 0})
      .noise (5_mm)
      .clutter (0.05)
      .build();
}

/** \brief The numbers 0 .. size - 1, mixed well. */
pcl::Indices
mixed (std::size_t size)
{
  constexpr std::size_t step = 7919;
  pcl::Indices order (size);
  for (std::size_t i = 0; i < size; ++i)
    order[i] = static_cast<pcl::index_t> (i * step % size);
  return order;
}

} // namespace

TEST (PointOrder, DoesNotMatter)
{
  const LabelledScene scene = furnishedRoom();
  const pcl::Indices order = mixed (scene.cloud->size());
  pcl::PointCloud<pcl::PointXYZ>::Ptr shuffled (
      new pcl::PointCloud<pcl::PointXYZ> (*scene.cloud, order));
  std::vector<pcl_ops::PlaneSegment> planes, planes_of_shuffled;
  ASSERT_TRUE (defaultsOn (scene.cloud).segment (planes));
  ASSERT_TRUE (defaultsOn (shuffled).segment (planes_of_shuffled));
  ASSERT_EQ (planes.size(), scene.surfaces.size());
  ASSERT_EQ (planes_of_shuffled.size(), planes.size());
  for (std::size_t p = 0; p < planes.size(); ++p) {
    pcl::Indices inliers;
    for (const pcl::index_t i : planes_of_shuffled[p].inliers)
      inliers.push_back (order[static_cast<std::size_t> (i)]);
    std::sort (inliers.begin(), inliers.end());
    EXPECT_EQ (inliers, planes[p].inliers) << "plane " << p;
  }
}
