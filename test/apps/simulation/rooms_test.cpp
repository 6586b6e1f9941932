// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "simulated_scenes.h"
#include <simulation/board_furniture.h>
#include <simulation/room.h>

using namespace pcl_ops::simulation;

namespace {

using Eigen::Vector3d;

std::vector<Furniture>
onePieceOfEachKind ()
{
  Random random (seedOfTest());
  return {drawBoardTable (random), drawBoardBench (random), drawBoardRack (random)};
}

/** \brief Of what is turned by that angle about the vertical before. */
Eigen::AlignedBox3d
boxAround (const Body& body, double turn = 0.0)
{
  Eigen::AlignedBox3d box;
  for (const Rectangle& face : body.rectangles)
    for (const double u : {-1.0, 1.0})
      for (const double v : {-1.0, 1.0})
        box.extend (turnZ (turn) *
                    Vector3d (face.center + u * face.half_u * face.axis_u +
                              v * face.half_v * face.axis_v));
  return box;
}

bool
areInOnePlane (const Rectangle& a, const Rectangle& b)
{
  constexpr double slightest_offset = 0.015; // [m]
  return std::abs (a.normal().dot (b.normal())) > 0.99 &&
         std::abs (a.normal().dot (b.center - a.center)) < slightest_offset;
}

} // namespace

TEST (Scene, RayMeetsTheNearestShape)
{
  const Scene scene = stepScene (2.0, 4.0);
  const Hit left = castRay (scene, Vector3d::Zero(), {-0.1, 0.0, 1.0});
  const Hit right = castRay (scene, Vector3d::Zero(), {0.1, 0.0, 1.0});
  EXPECT_DOUBLE_EQ (left.distance, 2.0);
  EXPECT_DOUBLE_EQ (right.distance, 4.0);
  EXPECT_NE (left.surface, right.surface);
}

TEST (Scene, RayMeetsRoundThingsOnTheirSkin)
{
  Body round;
  round.spheres.push_back ({{0.0, 0.0, 3.0}, 0.5});
  round.cylinders.push_back ({{2.0, 0.0, 3.0}, Vector3d::UnitY(), 1.0, 0.5});
  round.cylinders.push_back ({{5.0, 0.0, 3.0}, Vector3d::UnitZ(), 1.0, 0.5});
  Scene scene;
  addBody (scene, round, Eigen::Isometry3d::Identity());
  const auto distanceFrom = [&scene] (double x, double y, double slant) {
    const Hit hit = castRay (scene, {x, y, 0.0}, {slant, 0.0, 1.0});
    EXPECT_EQ (hit.surface, no_surface);
    return hit.distance;
  };
  EXPECT_DOUBLE_EQ (distanceFrom (0.0, 0.0, 0.0), 2.5);
  EXPECT_DOUBLE_EQ (distanceFrom (2.0, 0.9, 0.0), 2.5);
  EXPECT_TRUE (std::isinf (distanceFrom (2.0, 1.1, 0.0)));
  EXPECT_NEAR (distanceFrom (5.2, 0.0, 0.01), 2.0, 1e-12); // the end of a cylinder
}

TEST (Scene, FacesOfABoxAreSurfacesOfTheirOwnUnlessNarrow)
{
  Body board;
  addBox (board, Eigen::Isometry3d::Identity(), {1.0, 0.6, 0.03});
  EXPECT_EQ (board.rectangles.size(), 6u);
  EXPECT_EQ (board.surface_count, 2u);
}

TEST (Scene, DividedItMeetsRaysAsBefore)
{
  const Scene scene = makeRoom (seedOfTest()).scene;
  const Scene parts = divided (scene, 0.5);
  Random random (seedOfTest());
  for (int i = 0; i < 2000; ++i) {
    const Vector3d ray = random.inBox ({-1, -1, -1}, {1, 1, 1});
    EXPECT_EQ (castRay (parts, {0.0, 0.0, 1.5}, ray).distance,
               castRay (scene, {0.0, 0.0, 1.5}, ray).distance);
  }
}

TEST (BoardFurniture, EveryFaceIsAPlaneOfItsOwn)
{
  for (const Furniture& piece : onePieceOfEachKind()) {
    const std::vector<Rectangle>& faces = piece.body.rectangles;
    EXPECT_EQ (piece.body.surface_count, faces.size());
    for (std::size_t i = 0; i < faces.size(); ++i) {
      EXPECT_EQ (faces[i].surface, i + 1);
      for (std::size_t j = 0; j < i; ++j)
        EXPECT_FALSE (areInOnePlane (faces[i], faces[j])) << i << ' ' << j;
    }
  }
}

TEST (Room, IsFurnishedWithinItsWalls)
{
  for (const std::uint32_t seed : seedsOfTest (20)) {
    const Room room = makeRoom (seed);
    EXPECT_GT (room.scene.bodies.size(), 4u);
    for (std::size_t i = 1; i < room.scene.bodies.size(); ++i) {
      const Vector3d center = turnZ (-room.yaw) * room.scene.bounds[i].center;
      EXPECT_LT (2.0 * std::abs (center.x()), room.size.x()) << seed;
      EXPECT_LT (2.0 * std::abs (center.y()), room.size.y()) << seed;
    }
  }
}

TEST (Corner, HasPiecesApartFromEachOtherWithinTheWalls)
{
  for (const std::uint32_t seed : seedsOfTest (20)) {
    const Room corner = makeFurnishedCorner (seed);
    EXPECT_GE (corner.scene.bodies.size(), 4u) << seed;
    const Vector3d half (0.5 * corner.size.x(), 0.5 * corner.size.y(), 1e9);
    const Eigen::AlignedBox3d room (Vector3d (-half.x(), -half.y(), 0.0), half);
    std::vector<Eigen::AlignedBox3d> placed;
    for (std::size_t i = 1; i < corner.scene.bodies.size(); ++i) {
      const Eigen::AlignedBox3d piece = boxAround (corner.scene.bodies[i], -corner.yaw);
      EXPECT_TRUE (room.intersection (piece).sizes().isApprox (piece.sizes(), 1e-6))
          << seed;
      for (const Eigen::AlignedBox3d& other : placed)
        EXPECT_GT (other.exteriorDistance (piece), 0.05) << seed;
      placed.push_back (piece);
    }
  }
}
