// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "presets.h"
#include "scene.h"

// Clouds whose parts have little in common: each is looked at on its own scale.

namespace {

const Surface ground = {{0, 0, 0}, {20, 0, 0}, {0, 20, 0}};
const Surface board = {{-2, 0, 0}, {0, 1, 0}, {0, 0, 1}};

LabelledScene
sampled (const Surface& surface, double spacing, double noise)
{
  return Scene()
      .surface (surface.corner, surface.first, surface.second)
      .spacing (spacing)
      .noise (noise)
      .build();
}

/** \brief Nine tenths of a surface's points are on one plane. */
bool
hasSurface (const std::vector<pcl_ops::PlaneSegment>& planes,
            const Surface& surface,
            std::size_t points,
            double offset)
{
  return std::any_of (planes.begin(), planes.end(), [&] (const auto& plane) {
    return isNear (plane.plane(), surface, 3_deg, offset) &&
           plane.inliers.size() > 90_percent * static_cast<double> (points);
  });
}

} // namespace

TEST (UnevenCloud, HasASparseGroundBesideADenseBoard)
{
  // Ten points a square metre beside a hundred thousand.
  const auto sparse = sampled (ground, 1.0 / std::sqrt (10.0), 1_cm);
  const auto dense = sampled (board, 1.0 / std::sqrt (1e5), 1_mm);
  const auto cloud = pcl::make_shared<Cloud> (*sparse.cloud + *dense.cloud);
  Ops ops;
  ops.setInputCloud (cloud);
  const auto planes = planesOf (ops);
  EXPECT_TRUE (hasSurface (planes, ground, sparse.cloud->size(), 3_cm));
  EXPECT_TRUE (hasSurface (planes, board, dense.cloud->size(), 1_cm));
}

TEST (UnevenCloud, HasAPlaneWithAThousandTimesTheNoiseOfAnother)
{
  const Surface wall = {{-3, 0, 0}, {0, 20, 0}, {0, 0, 20}};
  const auto noisy = sampled (ground, 10_cm, 10_cm);
  const auto exact = sampled (wall, 10_cm, 1e-4);
  const auto cloud = pcl::make_shared<Cloud> (*noisy.cloud + *exact.cloud);
  Ops ops;
  ops.setInputCloud (cloud);
  const auto planes = planesOf (ops);
  EXPECT_TRUE (hasSurface (planes, ground, noisy.cloud->size(), 3_cm));
  EXPECT_TRUE (hasSurface (planes, wall, exact.cloud->size(), 1_mm));
}

TEST (UnevenCloud, OfOneVoxelHasAPlaneOrNone)
{
  Ops ops;
  auto parameters = ops.getParameters();
  parameters.surfels.voxel_size = 1000_m;
  ops.setParameters (parameters);
  ops.setInputCloud (room().build().cloud);
  EXPECT_LE (planesOf (ops).size(), 1u);
}
