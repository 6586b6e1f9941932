// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "simulated_scenes.h"
#include <simulation/furniture.h>
#include <simulation/room.h>
#include <simulation/shapes.h>
#include <simulation/street.h>
#include <simulation/survey.h>
#include <simulation/town.h>

#include <array>
#include <map>
#include <set>

using namespace pcl_ops::simulation;

namespace {

using Eigen::Vector3d;

std::vector<Body>
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
  for (const Shape& face : body.shapes)
    for (const double u : {-1.0, 1.0})
      for (const double v : {-1.0, 1.0})
        box.extend (turnZ (turn) * Vector3d (face.center + u * face.half_u * face.u +
                                             v * face.half_v * face.v));
  return box;
}

bool
areInOnePlane (const Shape& a, const Shape& b)
{
  constexpr double slightest_offset = 0.015; // [m]
  return std::abs (a.normal().dot (b.normal())) > 0.99 &&
         std::abs (a.normal().dot (b.center - a.center)) < slightest_offset;
}

constexpr double some_points = 1e5;

/** \brief A single house in the middle of its ground, with a ridge along x. */
Survey
lonelyHouse ()
{
  Survey survey;
  survey.houses.emplace_back();
  survey.width = 30.0;
  return survey;
}

/** \brief The points of all tiles, sorted. */
std::vector<TownPoint>
allPoints (const Town& town)
{
  std::vector<TownPoint> points;
  for (std::uint32_t row = 0; row < town.tiles; ++row)
    for (std::uint32_t column = 0; column < town.tiles; ++column)
      for (const TownPoint& point : surveyTile (town, column, row, 1.0))
        points.push_back (point);
  const auto key = [] (const TownPoint& point) {
    const Eigen::Vector3d& p = point.position;
    return std::array<double, 3>{p.x(), p.y(), p.z()};
  };
  std::sort (points.begin(), points.end(), [&] (const auto& a, const auto& b) {
    return key (a) < key (b);
  });
  return points;
}

/** \brief How many of 10,000 points drawn from a shape \p isCounted says yes to. */
template <typename IsCounted>
int
countDrawn (const RoundShape& shape, const IsCounted& isCounted)
{
  Random random (seedOfTest());
  int counted = 0;
  for (int i = 0; i < 10000; ++i)
    counted += isCounted (drawPoint (shape, random));
  return counted;
}

} // namespace

TEST (Scene, RayMeetsTheNearestShape)
{
  const ShapeTree scene = treeOf (stepScene (2.0, 4.0));
  const Hit left = castRay (scene, Vector3d::Zero(), {-0.1, 0.0, 1.0});
  const Hit right = castRay (scene, Vector3d::Zero(), {0.1, 0.0, 1.0});
  EXPECT_DOUBLE_EQ (left.distance, 2.0);
  EXPECT_DOUBLE_EQ (right.distance, 4.0);
  EXPECT_NE (left.surface, right.surface);
}

TEST (Scene, RayMeetsRoundThingsOnTheirSkin)
{
  Body round;
  round.addSphere ({0.0, 0.0, 3.0}, 0.5);
  round.addCylinder ({2.0, 0.0, 3.0}, Vector3d::UnitY(), 1.0, 0.5);
  round.addCylinder ({5.0, 0.0, 3.0}, Vector3d::UnitZ(), 1.0, 0.5);
  Scene scene;
  scene.add (round, Eigen::Isometry3d::Identity());
  const auto distanceFrom = [tree = treeOf (scene)] (double x, double y, double slant) {
    const Hit hit = castRay (tree, {x, y, 0.0}, {slant, 0.0, 1.0});
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
  board.addBox (Eigen::Isometry3d::Identity(), {1.0, 0.6, 0.03});
  EXPECT_EQ (board.shapes.size(), 6u);
  EXPECT_EQ (board.surface_count, 2u);
}

TEST (Scene, RayMeetsTheNearestOfAllShapesOneByOne)
{
  const Scene scene = makeRoom (seedOfTest()).scene;
  const ShapeTree tree = treeOf (scene);
  const Vector3d eye (0.0, 0.0, 1.5);
  Random random (seedOfTest());
  for (int i = 0; i < 500; ++i) {
    const Vector3d ray = random.inBox ({-1, -1, -1}, {1, 1, 1});
    double nearest = std::numeric_limits<double>::infinity();
    for (const Body& body : scene.bodies)
      for (const Shape& shape : body.shapes)
        nearest = std::min (
            nearest,
            castRay (treeOf ({{{Vector2d::Zero(), {shape}}}}), eye, ray).distance);
    EXPECT_EQ (castRay (tree, eye, ray).distance, nearest);
  }
}

TEST (BoardFurniture, EveryFaceIsAPlaneOfItsOwn)
{
  for (const Body& piece : onePieceOfEachKind()) {
    const std::vector<Shape>& faces = piece.shapes;
    EXPECT_EQ (piece.surface_count, faces.size());
    for (std::size_t i = 0; i < faces.size(); ++i) {
      EXPECT_EQ (faces[i].surface, i + 1);
      for (std::size_t j = 0; j < i; ++j)
        EXPECT_FALSE (areInOnePlane (faces[i], faces[j])) << i << ' ' << j;
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

TEST (Survey, HasAGroundAndSixPlanesForEachHouse)
{
  const std::uint32_t seed = seedOfTest();
  for (const std::size_t houses : {1u, 3u, 5u}) {
    const auto simulated =
        scanSurvey (makeSurvey (seed, houses), 5000 * houses, 1.0, seed);
    EXPECT_EQ (simulated.planes.size(), 1 + 6 * houses);
    for (const auto& point : simulated.cloud)
      ASSERT_GT (point.label, 0u);
  }
}

TEST (Survey, HasNoGroundInAHouseAndNothingOutOfTheRoof)
{
  const Survey survey = lonelyHouse();
  const House& house = survey.houses.front();
  const double rise = 2.0 * (house.ridge - house.eaves) / house.width;
  for (const auto& point : scanSurvey (survey, 5000, 0.0, seedOfTest()).cloud) {
    const bool is_inside = std::abs (point.x) < 7.4f && std::abs (point.y) < 5.4f;
    EXPECT_FALSE (is_inside && point.z < 4.9f);
    if (point.z > 0.0f) {
      EXPECT_LT (point.z, house.ridge - rise * std::abs (point.y) + 5.0 * rounding);
    }
  }
}

TEST (Town, HasTheSamePointsInAnyNumberOfTiles)
{
  const auto one = allPoints (makeTown (1, some_points, 1));
  const auto nine = allPoints (makeTown (1, some_points, 8));
  ASSERT_EQ (one.size(), nine.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    ASSERT_EQ (one[i].position, nine[i].position);
    ASSERT_EQ (one[i].label, nine[i].label);
  }
}

TEST (Town, HasAboutAsManyPointsAsAskedFor)
{
  constexpr double many_points = 1e6;
  const auto found = double (allPoints (makeTown (1, many_points, 4)).size());
  EXPECT_NEAR (found / many_points, 1.0, 0.2);
}

TEST (Town, HasAPlaneForEachLabel)
{
  constexpr double enough_points = 500;
  std::map<std::uint32_t, pcl_ops::Moments> planes;
  const Town town = makeTown (2, some_points, 1);
  for (const TownPoint& point : surveyTile (town, 0, 0, 1.0)) {
    const Eigen::Vector3d local = point.position - town.corner;
    planes[point.label].add (local.x(), local.y(), local.z());
  }
  EXPECT_GT (planes.size(), 10u);
  for (const auto& [label, moments] : planes)
    if (moments.count >= enough_points) {
      const auto fit = pcl_ops::fitPlane (moments);
      ASSERT_TRUE (fit);
      EXPECT_NEAR (std::sqrt (fit->variances[0]), survey_sigma, 0.002) << label;
    }
}

TEST (Street, WindowsOfAHouseAreOnePlaneBehindTheFacade)
{
  constexpr int most_faces_of_a_car = 10;
  const auto isFlat = [] (const Shape& shape) { return shape.surface != no_surface; };
  int houses = 0;
  for (const Body& body : makeStreet (seedOfTest()).scene.bodies) {
    const std::vector<Shape>& shapes = body.shapes;
    if (std::count_if (shapes.begin(), shapes.end(), isFlat) <= most_faces_of_a_car)
      continue;
    ++houses;
    std::set<SurfaceId> facing;
    for (const Shape& shape : shapes) // that of the facade is the first
      if (std::abs (shape.normal().dot (shapes[0].normal())) > 0.99)
        facing.insert (shape.surface);
    EXPECT_EQ (facing.size(), 3u); // facade, windows, door
  }
  EXPECT_GT (houses, 10);
}

TEST (Shapes, AreTwoPlanesAndPointsOnNone)
{
  const auto simulated = simulateShapes (5000, 1.0, seedOfTest());
  EXPECT_EQ (simulated.planes.size(), 2u);
  const auto on_none =
      std::count_if (simulated.cloud.begin(),
                     simulated.cloud.end(),
                     [] (const auto& point) { return point.label == 0; });
  EXPECT_GT (on_none, 1000);
}

TEST (SurfacePoints, AreDenseEvenly)
{
  using Kind = RoundShape::Kind;
  const RoundShape cone{Kind::Cone, Vector3d::Zero(), 0.5, 1.0};
  EXPECT_NEAR (countDrawn (cone, [] (const auto& p) { return p.position.z() > -0.5; }),
               2500,
               150);
  const RoundShape dome{Kind::Dome, Vector3d::Zero(), 1.0, 0.2};
  EXPECT_NEAR (countDrawn (dome, [] (const auto& p) { return p.position.z() > 0.9; }),
               5000, // Archimedes
               200);
  const RoundShape torus{Kind::Torus, Vector3d::Zero(), 0.5, 0.15};
  const auto isOutside = [] (const auto& p) {
    return p.position.template head<2>().norm() > 0.5;
  };
  EXPECT_NEAR (countDrawn (torus, isOutside), 10000 * (0.5 + 0.3 / pi), 150);
}

TEST (SurfacePoints, APartOfATurnIsDenseEvenlyAboutItsMiddle)
{
  const RoundShape quarter{
      RoundShape::Kind::Cylinder, Vector3d::Zero(), 0.1, 0.5, 0.25};
  const int in_middle_half = countDrawn (quarter, [] (const SurfacePoint& point) {
    const double around = std::atan2 (point.position.x(), point.position.y());
    EXPECT_LE (std::abs (around), 0.25 * pi + 1e-9);
    EXPECT_GT (point.normal.dot (point.position), 0.0);
    return std::abs (around) < 0.125 * pi;
  });
  EXPECT_NEAR (in_middle_half, 5000, 200);
}
