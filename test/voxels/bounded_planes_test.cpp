// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxel_scene.h"
#include "voxels/bounded_planes.h"

using pcl_ops::Labels;
using pcl_ops::Moments;
using pcl_ops::no_plane;
using pcl_ops::Plane;
using namespace pcl_ops::internal;

namespace {

/** \brief A plane through the middle of the ground, tilted by 6 degrees. */
const Plane tilted =
    pcl_ops::planeThrough (ground.center(), Eigen::Vector3d (0.1, 0, 1).normalized());

/** \brief The horizontal plane at a height z [m]. */
Plane
levelPlaneAt (double z)
{
  return {Eigen::Vector3d::UnitZ(), -z};
}

/** \brief Three points in three voxels side by side, at x = 5, 15 and 25 cm. */
VoxelGrid
threeVoxels ()
{
  Coordinates points;
  for (const float x : {0.05f, 0.15f, 0.25f})
    points.add (x, 0.05f, 0.05f);
  return voxelize (points, 10_cm, one_thread);
}

/** \brief Two planes on the voxels of \ref threeVoxels.
 * \param[in] plane_of_point for each of the three points the plane of its voxel */
BoundedPlanes
planesOf (const VoxelGrid& grid, const Labels& plane_of_point)
{
  BoundedPlanes planes;
  planes.planes.resize (2);
  planes.plane_of_voxel.resize (3);
  const Indices voxels = voxelsOfPoints (grid);
  for (std::size_t i = 0; i < 3; ++i)
    planes.plane_of_voxel[voxels[i]] = plane_of_point[i];
  return planes;
}

} // namespace

TEST (Refitting, FitsEachPlaneToItsVoxelsAndLeavesAPlaneWithoutVoxelsAsItIs)
{
  VoxelScene scene ({{ground}, {wall}});
  scene.planes.planes = {tilted, tilted, tilted}; // plane 2 has no voxels
  // Voxels with points of both surfaces are on no plane.
  scene.label (no_plane, [] (const Eigen::Vector3d& centroid) {
    return centroid.x() < 0.1 && centroid.z() < 0.1;
  });
  refitPlanes (scene.grid(), scene.planes);
  constexpr double max_angle = 1e-6;    // [rad]
  constexpr double max_distance = 1e-6; // [m]
  EXPECT_TRUE (isNear (scene.planes.planes[0], ground, max_angle, max_distance));
  EXPECT_TRUE (isNear (scene.planes.planes[1], wall, max_angle, max_distance));
  EXPECT_EQ (scene.planes.planes[2].normal, tilted.normal);
}

TEST (MomentsOfPlanes, AddUpThePointsOfTheirVoxelsAndWhatTheyHaveElsewhere)
{
  const VoxelGrid grid = threeVoxels();
  for (const bool has_point_elsewhere : {false, true}) {
    BoundedPlanes planes = planesOf (grid, {1, no_plane, 1});
    if (has_point_elsewhere) { // plane 0 alone
      planes.moments_elsewhere.resize (1);
      planes.moments_elsewhere[0].add (1, 2, 3);
    }
    const std::vector<Moments> moments = momentsOfPlanes (grid, planes);
    ASSERT_EQ (moments.size(), 2u);
    EXPECT_EQ (moments[0].count, has_point_elsewhere ? 1.0 : 0.0) << "without voxels";
    EXPECT_EQ (moments[1].count, 2.0);
    EXPECT_NEAR (moments[1].sum.x(), 0.05 + 0.25, 1e-6);
  }
}

TEST (MomentsOf, SomeVoxelsAddUpTheirPoints)
{
  const Moments moments = momentsOf (threeVoxels().moments, Indices{0, 1});
  EXPECT_EQ (moments.count, 2.0);
  EXPECT_NEAR (moments.centroid().x(), 0.10, 1e-6);
}

TEST (Renumbering, MovesVoxelsAndMomentsToTheMergedPlanes)
{
  BoundedPlanes planes;
  planes.planes = {
      levelPlaneAt (0), levelPlaneAt (1), levelPlaneAt (2), levelPlaneAt (3)};
  planes.plane_of_voxel = {0, 1, 2, 3, no_plane, 1};
  planes.moments_elsewhere.resize (4);
  const double distinct_sums[] = {1.0, 2.0, 4.0, 8.0}; // x; the sum tells whose it is
  for (const int plane : {0, 1, 2, 3})
    planes.moments_elsewhere[plane].add (distinct_sums[plane], 0, 0);
  pcl_ops::MergedPlanes merged;
  merged.merged_into = {1, 0, 1, no_plane}; // plane 3 is in no merged plane
  merged.fits.resize (2);
  merged.fits[0].plane = levelPlaneAt (5);
  merged.fits[1].plane = levelPlaneAt (6);
  renumberPlanes (merged, planes);
  EXPECT_EQ (planes.plane_of_voxel, (Labels{1, 0, 1, no_plane, no_plane, 0}));
  ASSERT_EQ (planes.size(), 2u);
  EXPECT_EQ (planes.planes[0].offset, -5.0);
  EXPECT_EQ (planes.planes[1].offset, -6.0);
  ASSERT_EQ (planes.moments_elsewhere.size(), 2u);
  EXPECT_EQ (planes.moments_elsewhere[0].sum.x(), 2.0);
  EXPECT_EQ (planes.moments_elsewhere[1].sum.x(), 1.0 + 4.0);
}
