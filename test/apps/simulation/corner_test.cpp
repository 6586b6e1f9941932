// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_checks.h"
#include "simulated_scene.h"
#include <simulation/board_furniture.h>
#include <simulation/corner.h>
#include <simulation/dense_scan.h>
#include <simulation/draws.h>

#include <algorithm>

using namespace pcl_ops::simulation;

namespace {

std::vector<Furniture>
onePieceOfEachKind ()
{
  auto generator = makeGenerator (seedOfTest(), Purpose::Corner);
  return {makeBoardTable (generator),
          makeBoardBench (generator),
          makeBoardRack (generator)};
}

double
widthOf (const Rectangle& rectangle)
{
  return 2.0 * std::min (rectangle.half_u, rectangle.half_v);
}

/** \brief Of what is turned by that angle about the vertical before. */
Eigen::AlignedBox3d
boxAround (const Body& body, double turn = 0.0)
{
  const Eigen::AngleAxisd turned (turn, Eigen::Vector3d::UnitZ());
  Eigen::AlignedBox3d box;
  for (const Rectangle& face : body.rectangles)
    for (const double side_u : {-1.0, 1.0})
      for (const double side_v : {-1.0, 1.0})
        box.extend (turned *
                    Eigen::Vector3d (face.center + side_u * face.half_u * face.axis_u +
                                     side_v * face.half_v * face.axis_v));
  return box;
}

bool
areInOnePlane (const Rectangle& a, const Rectangle& b)
{
  constexpr double slightest_offset = 0.015; // [m]
  return std::abs (a.normal().dot (b.normal())) > 0.99 &&
         std::abs (a.normal().dot (b.center - a.center)) < slightest_offset;
}

SimulatedCloud
imageOfCorner (std::uint32_t seed, NoiseProfile profile)
{
  const Room corner = makeFurnishedCorner (seed);
  DepthCamera camera;
  camera.width = 320;
  camera.height = 240;
  camera.pose = drawCameraPose (corner, camera, seed);
  return toCloud (measureDepth (corner.scene, camera, noiseOf (profile), seed),
                  camera,
                  corner.scene,
                  CloudLayout::Readings);
}

} // namespace

TEST (BoardFurniture, EveryFaceIsAPlaneOfItsOwn)
{
  for (const Furniture& piece : onePieceOfEachKind()) {
    std::vector<SurfaceId> surfaces;
    for (const Rectangle& face : piece.body.rectangles)
      surfaces.push_back (face.surface);
    std::sort (surfaces.begin(), surfaces.end());
    ASSERT_FALSE (surfaces.empty());
    EXPECT_NE (surfaces.front(), no_surface);
    EXPECT_EQ (std::adjacent_find (surfaces.begin(), surfaces.end()), surfaces.end());
  }
}

TEST (BoardFurniture, RimsAndPostsAreTwoToSixCentimetresWide)
{
  for (const Furniture& piece : onePieceOfEachKind()) {
    std::size_t narrow = 0;
    for (const Rectangle& face : piece.body.rectangles) {
      EXPECT_GE (widthOf (face), thinnest_board);
      narrow += widthOf (face) <= thickest_board;
    }
    EXPECT_GE (narrow, 4u + 4u * 4u); // the rims of a board, the sides of four posts
  }
}

TEST (BoardFurniture, NoTwoFacesAreInOnePlane)
{
  for (const Furniture& piece : onePieceOfEachKind()) {
    const std::vector<Rectangle>& faces = piece.body.rectangles;
    for (std::size_t i = 0; i < faces.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        EXPECT_FALSE (areInOnePlane (faces[i], faces[j])) << i << ' ' << j;
  }
}

TEST (BoardFurniture, StandsOnTheFloorWithinItsFootprint)
{
  for (const Furniture& piece : onePieceOfEachKind()) {
    const Eigen::AlignedBox3d box = boxAround (piece.body);
    EXPECT_NEAR (box.min().z(), 0.0, 1e-9);
    EXPECT_TRUE (box.sizes().head<2>().isApprox (piece.footprint, 1e-9));
  }
}

TEST (Furnisher, PlacesPiecesApartFromEachOtherWithinTheWalls)
{
  for (std::uint32_t seed = seedOfTest(), last = seed + 20; seed != last; ++seed) {
    const Room corner = makeFurnishedCorner (seed);
    const Eigen::AlignedBox3d room (
        Eigen::Vector3d (-0.5 * corner.size.x(), -0.5 * corner.size.y(), 0.0),
        Eigen::Vector3d (0.5 * corner.size.x(), 0.5 * corner.size.y(), 1e9));
    std::vector<Eigen::AlignedBox3d> placed;
    for (std::size_t i = 1; i < corner.scene.bodies.size(); ++i) {
      const Eigen::AlignedBox3d piece = boxAround (corner.scene.bodies[i], -corner.yaw);
      EXPECT_LT (room.exteriorDistance (piece.center()), 1e-9) << seed;
      EXPECT_TRUE (room.intersection (piece).sizes().isApprox (piece.sizes(), 1e-6))
          << seed;
      for (const Eigen::AlignedBox3d& other : placed)
        EXPECT_GT (other.exteriorDistance (piece), 0.05) << seed;
      placed.push_back (piece);
    }
  }
}

TEST (FurnishedCorner, HasAFloorAndTwoWallsAndNothingOpposite)
{
  const Room corner = makeFurnishedCorner (seedOfTest());
  EXPECT_EQ (corner.scene.bodies.front().surface_count, 3u);
  const Eigen::Vector3d eye (0.0, 0.0, corner.size.z() - 0.01);
  int walls = 0;
  for (int quarter = 0; quarter < 4; ++quarter) {
    const Eigen::Vector3d outward =
        Eigen::AngleAxisd (corner.yaw + 0.5 * pi * quarter, Eigen::Vector3d::UnitZ()) *
        Eigen::Vector3d::UnitX();
    walls += std::isfinite (castRay (corner.scene, eye, outward).distance);
  }
  EXPECT_EQ (walls, 2);
}

TEST (FurnishedCorner, IsFurnished)
{
  for (std::uint32_t seed = seedOfTest(), last = seed + 20; seed != last; ++seed)
    EXPECT_GE (makeFurnishedCorner (seed).scene.bodies.size(), 4u) << seed;
}

TEST (FurnishedCorner, IsSeenWithNarrowPlanesThatHavePointsEnough)
{
  const std::uint32_t seed = seedOfTest();
  const Room corner = makeFurnishedCorner (seed);
  const SimulatedCloud image = imageOfCorner (seed, NoiseProfile::Correlated);
  const auto isNarrow = [&] (const LabeledPlane& seen) {
    for (const Body& body : corner.scene.bodies)
      for (const Rectangle& face : body.rectangles)
        if (widthOf (face) <= thickest_board && seen.plane.normal == face.normal() &&
            seen.plane.distance (face.center) == 0.0)
          return true;
    return false;
  };
  EXPECT_GE (std::count_if (image.planes.begin(), image.planes.end(), isNarrow), 5);
}

TEST (FurnishedCorner, ExactPointsLieOnThePlaneOfTheirLabel)
{
  const auto image = imageOfCorner (seedOfTest(), NoiseProfile::None);
  EXPECT_GT (image.planes.size(), 5u);
  EXPECT_LT (largestDistanceToTruth (image), rounding);
}

TEST (FurnishedCorner, IsScannedFromEverywhereAsARoomIs)
{
  const Room corner = makeFurnishedCorner (seedOfTest());
  const auto scan = scanDensely (corner.scene, 5000, 0.0, seedOfTest());
  EXPECT_EQ (scan.cloud.size(), 5000u);
  for (const auto& point : scan.cloud)
    EXPECT_LT (point.z, corner.size.z() + rounding);
}

TEST (FurnishedCorner, SameSeedSameCloud)
{
  const std::uint32_t seed = seedOfTest();
  const auto first = imageOfCorner (seed, NoiseProfile::Raw);
  EXPECT_TRUE (haveSamePoints (first, imageOfCorner (seed, NoiseProfile::Raw)));
  EXPECT_FALSE (haveSamePoints (first, imageOfCorner (seed + 1, NoiseProfile::Raw)));
}
