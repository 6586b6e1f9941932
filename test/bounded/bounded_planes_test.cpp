// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bounded/bounded_planes.h"
#include "voxel_scene.h"

using pcl_ops::Labels;
using pcl_ops::Moments;
using pcl_ops::no_plane;
using pcl_ops::Plane;
using namespace pcl_ops::internal;

namespace {

// In the middle of voxels of 10 cm; 20 x 20 of them each.
const Surface ground = {{0, 0, 0.05}, {2, 0, 0}, {0, 2, 0}};
const Surface wall = {{0.05, 0, 0}, {0, 2, 0}, {0, 0, 2}};

const Plane tilted =
    pcl_ops::planeThrough (ground.centre(), Eigen::Vector3d (0.1, 0, 1).normalized());

Plane
atHeight (double z)
{
  return {Eigen::Vector3d::UnitZ(), -z};
}

/** \brief Three points in three voxels side by side, at x = 5, 15 and 25 cm. */
VoxelizedPoints
threeVoxels ()
{
  Coordinates points;
  for (const float x : {0.05f, 0.15f, 0.25f})
    points.add (x, 0.05f, 0.05f);
  return voxelize (points, 10_cm, 1);
}

/** \brief Voxels of \ref threeVoxels on planes. */
BoundedPlanes
planesOf (const VoxelizedPoints& voxelized, const Labels& plane_of_point)
{
  BoundedPlanes planes;
  planes.planes.resize (2);
  planes.plane_of_voxel.resize (3);
  for (std::size_t i = 0; i < 3; ++i)
    planes.plane_of_voxel[voxelized.voxel_of_point[i]] = plane_of_point[i];
  return planes;
}

} // namespace

TEST (Reassignment, GivesAVoxelBackToTheNearerPlaneNextToIt)
{
  VoxelScene scene ({{ground}, {wall}});
  const Labels truth = scene.planes.plane_of_voxel;
  scene.label (1, [] (const auto& at) { return at.x() < 0.2 && at.z() < 0.1; });
  EXPECT_NE (scene.planes.plane_of_voxel, truth);
  reassignVoxels (scene.grid(), 1, scene.planes);
  // The row where they meet may go either way.
  scene.label (0, [] (const auto& at) { return at.x() < 0.1 && at.z() < 0.1; });
  EXPECT_EQ (scene.planes.plane_of_voxel, truth);
}

TEST (Reassignment, LeavesVoxelsOffPlanesAlone)
{
  VoxelScene scene ({{ground}});
  scene.label (no_plane, [] (const auto& at) { return at.x() < 0.2; });
  reassignVoxels (scene.grid(), 1, scene.planes);
  EXPECT_EQ (scene.voxelsOn (no_plane), 40u);
}

TEST (Reassignment, RefitsThePlanes)
{
  VoxelScene scene ({{ground}});
  scene.planes.planes[0] = tilted;
  reassignVoxels (scene.grid(), 1, scene.planes);
  expectPlaneNear (scene.planes.planes[0], ground, 1e-6, 1e-6);
}

TEST (Reassignment, IsTheSameForAnyNumberOfThreads)
{
  VoxelScene one ({{ground}, {wall}}), four ({{ground}, {wall}});
  for (VoxelScene* const scene : {&one, &four})
    scene->label (1, [] (const auto& at) { return at.x() < 0.5; });
  reassignVoxels (one.grid(), 1, one.planes);
  reassignVoxels (four.grid(), 4, four.planes);
  EXPECT_EQ (one.planes.plane_of_voxel, four.planes.plane_of_voxel);
}

TEST (Refitting, FitsEachPlaneToItsVoxels)
{
  VoxelScene scene ({{ground}, {wall}});
  scene.planes.planes = {tilted, tilted};
  scene.label (no_plane, [] (const auto& at) { return at.x() < 0.1 && at.z() < 0.1; });
  refitPlanes (scene.grid(), scene.planes);
  expectPlaneNear (scene.planes.planes[0], ground, 1e-6, 1e-6);
  expectPlaneNear (scene.planes.planes[1], wall, 1e-6, 1e-6);
}

TEST (Refitting, LeavesAPlaneWithoutVoxelsAsItIs)
{
  VoxelScene scene ({{ground}});
  scene.planes.planes = {tilted, tilted};
  refitPlanes (scene.grid(), scene.planes);
  EXPECT_EQ (scene.planes.planes[1].normal, tilted.normal);
}

TEST (MomentsOfPlanes, AddUpThePointsOfTheirVoxels)
{
  const VoxelizedPoints three = threeVoxels();
  const auto moments = momentsOfPlanes (three.grid, planesOf (three, {1, no_plane, 1}));
  ASSERT_EQ (moments.size(), 2u);
  EXPECT_EQ (moments[0].count, 0.0);
  EXPECT_EQ (moments[1].count, 2.0);
  EXPECT_NEAR (moments[1].sum.x(), 0.05 + 0.25, 1e-6);
}

TEST (MomentsOfPlanes, HoldWhatPlanesHaveBeyondTheirVoxels)
{
  const VoxelizedPoints three = threeVoxels();
  BoundedPlanes planes = planesOf (three, {0, 0, 1});
  planes.beyond.resize (1);
  planes.beyond[0].add (1, 2, 3);
  const auto moments = momentsOfPlanes (three.grid, planes);
  ASSERT_EQ (moments.size(), 2u);
  EXPECT_EQ (moments[0].count, 3.0);
  EXPECT_EQ (moments[1].count, 1.0);
}

TEST (MomentsOf, SomeVoxelsAreThoseOfTheirPoints)
{
  const VoxelizedPoints three = threeVoxels();
  const Moments moments =
      momentsOf (three.grid, {three.voxel_of_point[0], three.voxel_of_point[1]});
  EXPECT_EQ (moments.count, 2.0);
  EXPECT_NEAR (moments.centroid().x(), 0.10, 1e-6);
}

TEST (ForNeighboursOnPlanes, VisitsTheVoxelItselfAndThoseAround)
{
  const VoxelizedPoints three = threeVoxels();
  const BoundedPlanes planes = planesOf (three, {0, 1, no_plane});
  std::vector<std::size_t> visited;
  const auto note = [&] (std::size_t plane, std::size_t) { visited.push_back (plane); };
  forNeighboursOnPlanes (
      three.grid, planes.plane_of_voxel, three.voxel_of_point[0], note);
  std::sort (visited.begin(), visited.end());
  EXPECT_EQ (visited, (std::vector<std::size_t>{0, 1}));
  visited.clear();
  forNeighboursOnPlanes (
      three.grid, planes.plane_of_voxel, three.voxel_of_point[2], note);
  EXPECT_EQ (visited, (std::vector<std::size_t>{1})) << "on no plane itself";
}

TEST (Renumbering, HandsVoxelsToThePlanesTheirsWereMergedInto)
{
  BoundedPlanes planes;
  planes.planes = {atHeight (0), atHeight (1), atHeight (2)};
  planes.plane_of_voxel = {0, 1, 2, no_plane, 1};
  pcl_ops::MergedPlanes merged;
  merged.merged_into = {1, 0, 1};
  merged.fits.resize (2);
  merged.fits[0].plane = atHeight (5);
  merged.fits[1].plane = atHeight (6);
  renumberPlanes (merged, planes);
  EXPECT_EQ (planes.plane_of_voxel, (Labels{1, 0, 1, no_plane, 0}));
  ASSERT_EQ (planes.size(), 2u);
  EXPECT_EQ (planes.planes[0].offset, -5.0);
  EXPECT_EQ (planes.planes[1].offset, -6.0);
}

TEST (Renumbering, TakesVoxelsOffPlanesThatWereDropped)
{
  BoundedPlanes planes;
  planes.planes = {atHeight (0)};
  planes.plane_of_voxel = {0, no_plane, 0};
  pcl_ops::MergedPlanes merged;
  merged.merged_into = {no_plane};
  renumberPlanes (merged, planes);
  EXPECT_EQ (planes.plane_of_voxel, Labels (3, no_plane));
  EXPECT_EQ (planes.size(), 0u);
}

TEST (Relabelling, AddsUpWhatPlanesHaveBeyondTheirVoxels)
{
  BoundedPlanes planes;
  planes.planes.resize (3);
  planes.beyond.resize (3);
  planes.beyond[0].add (1, 0, 0);
  planes.beyond[1].add (2, 0, 0);
  planes.beyond[2].add (4, 0, 0);
  relabelPlanes ({1, no_plane, 1}, 2, planes);
  ASSERT_EQ (planes.beyond.size(), 2u);
  EXPECT_EQ (planes.beyond[0].count, 0.0);
  EXPECT_EQ (planes.beyond[1].count, 2.0);
  EXPECT_EQ (planes.beyond[1].sum.x(), 5.0);
}

TEST (Relabelling, RemembersWhatThePlanesOfTheBeginningBecame)
{
  // Planes 0, 1 and 2 of the beginning; 1 went into 0 before, so that 2 is called 1.
  BoundedPlanes planes;
  planes.planes.resize (2);
  planes.became = {0, 0, 1};
  relabelPlanes ({1, 0}, 2, planes);
  EXPECT_EQ (planes.became, (Labels{1, 1, 0}));
}
