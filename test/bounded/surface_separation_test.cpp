// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bounded/surface_separation.h"
#include "voxel_scene.h"

#include <set>

using namespace pcl_ops::internal;

namespace {

// Two table tops of one height with the floor below, seen from above.
const Surface left_top = {{-1.2, -0.4, 1}, {0.9, 0, 0}, {0, 0.9, 0}};
const Surface right_top = {{0.3, -0.4, 1}, {0.9, 0, 0}, {0, 0.9, 0}};
const Surface wide_floor = {{-2, -2, 0}, {4, 0, 0}, {0, 4, 0}};
const Surface lamp = {{-0.4, -0.5, 2}, {0.8, 0, 0}, {0, 1, 0}};
const Eigen::Vector3d above (0, 0, 3);

std::size_t
planesAtHeight (double height, const BoundedPlanes& planes)
{
  return static_cast<std::size_t> (
      std::count_if (planes.planes.begin(),
                     planes.planes.end(),
                     [height] (const pcl_ops::Plane& plane) {
                       return std::abs (std::abs (plane.offset) - height) < 0.05;
                     }));
}

/** \brief After separation of what was one plane of both table tops. */
std::size_t
tableTopsFoundAmong (const std::vector<std::vector<Surface>>& planes,
                     std::size_t least_voxels = 20)
{
  VoxelScene scene (planes);
  EXPECT_EQ (planesAtHeight (1.0, scene.planes), 1u) << "one plane before";
  separateSurfaces (scene.grid(), above, least_voxels, scene.planes);
  return planesAtHeight (1.0, scene.planes);
}

} // namespace

TEST (SeparateSurfaces, KeepsTableTopsApartWhereTheFloorIsSeenBetween)
{
  EXPECT_EQ (tableTopsFoundAmong ({{left_top, right_top}, {wide_floor}}), 2u);
}

TEST (SeparateSurfaces, TakesATableTopForOneWhereALampHidesItsMiddle)
{
  EXPECT_EQ (tableTopsFoundAmong ({{left_top, right_top}, {wide_floor}, {lamp}}), 1u);
}

TEST (SeparateSurfaces, TakesATableTopForOneWhereNothingIsSeenBetween)
{
  EXPECT_EQ (tableTopsFoundAmong ({{left_top, right_top}}), 1u);
}

TEST (SeparateSurfaces, LeavesPartsOfFewerVoxelsWithTheirPlane)
{
  EXPECT_EQ (tableTopsFoundAmong ({{left_top, right_top}, {wide_floor}}, 1000), 1u);
}

TEST (SeparateSurfaces, GivesEachTableTopItsOwnVoxels)
{
  VoxelScene scene ({{left_top, right_top}, {wide_floor}});
  separateSurfaces (scene.grid(), above, 20, scene.planes);
  std::set<std::int32_t> left, right;
  for (std::size_t i = 0; i < scene.grid().size(); ++i)
    if (scene.centroid (i).z() > 0.5)
      (scene.centroid (i).x() < 0.0 ? left : right)
          .insert (scene.planes.plane_of_voxel[i]);
  EXPECT_EQ (left.size(), 1u);
  EXPECT_EQ (right.size(), 1u);
  EXPECT_NE (left, right);
}

TEST (SeparateSurfaces, FitsEachTableTopByItself)
{
  // The right one is 4 cm higher, which one plane hides by leaning.
  const Surface raised = {{0.3, -0.4, 1.04}, {0.9, 0, 0}, {0, 0.9, 0}};
  VoxelScene scene ({{left_top, raised}, {wide_floor}});
  refitPlanes (scene.grid(), scene.planes);
  EXPECT_GT (angleBetween (scene.planes.planes[0].normal, Eigen::Vector3d::UnitZ()),
             1_deg);
  separateSurfaces (scene.grid(), above, 20, scene.planes);
  ASSERT_EQ (scene.planes.size(), 3u);
  for (const pcl_ops::Plane& plane : scene.planes.planes)
    EXPECT_LT (angleBetween (plane.normal, Eigen::Vector3d::UnitZ()), 0.1_deg);
}
