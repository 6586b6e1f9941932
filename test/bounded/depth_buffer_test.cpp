// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bounded/depth_buffer.h"
#include "grid_scene.h"

using namespace pcl_ops::internal;

namespace {

/** \brief What a sensor at zero sees of a board of 1 m x 1 m, 2 m up. */
Sight
lookAt (const Eigen::Vector3d& place)
{
  Coordinates points;
  addGrid (points, {{-0.5, -0.5, 2.05}, {1, 0, 0}, {0, 1, 0}}, 60);
  const VoxelGrid grid = voxelize (points, 10_cm, 1).grid;
  return DepthBuffer (grid, Eigen::Vector3d::Zero()).lookAt (place, 20_cm);
}

} // namespace

TEST (DepthBuffer, SeesAVoxelWhereItIs)
{
  EXPECT_EQ (lookAt ({0, 0, 2}), Sight::There);
  EXPECT_EQ (lookAt ({0.45, -0.45, 2}), Sight::There);
}

TEST (DepthBuffer, SeesNothingHiddenByAVoxel)
{
  EXPECT_EQ (lookAt ({0, 0, 3}), Sight::Hidden);
}

TEST (DepthBuffer, LooksThroughWhatIsInFrontOfAVoxel)
{
  EXPECT_EQ (lookAt ({0, 0, 1}), Sight::Through);
}

TEST (DepthBuffer, SeesNothingWhereNoVoxelLiesThatWay)
{
  EXPECT_EQ (lookAt ({2, 0, 2}), Sight::Nothing) << "beside the board";
  EXPECT_EQ (lookAt ({0, 0, -2}), Sight::Nothing) << "behind the sensor";
  EXPECT_EQ (lookAt ({0, 0, 0}), Sight::Nothing) << "the sensor itself";
}

TEST (DepthBuffer, LooksAllAround)
{
  const Eigen::Vector3d viewpoint (1, 2, 3);
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {2.0, -2.0}) {
      const Eigen::Vector3d place = viewpoint + side * Eigen::Vector3d::Unit (axis);
      Coordinates point;
      point.add (static_cast<float> (place.x()),
                 static_cast<float> (place.y()),
                 static_cast<float> (place.z()));
      const DepthBuffer view (voxelize (point, 10_cm, 1).grid, viewpoint);
      EXPECT_EQ (view.lookAt (place, 20_cm), Sight::There);
      EXPECT_EQ (view.lookAt (2.0 * viewpoint - place, 20_cm), Sight::Nothing);
    }
}
